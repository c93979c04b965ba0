// SPDX-License-Identifier: MIT
// Settings of the session as JSON: rows of run_fields(), by name.
#pragma once

#include "pliant/run/run_fields.hpp"
#include "reply.hpp"

namespace pliant::play {

/// Sets an option from a JSON value. A seed may be text. Throws OptionError for a value of another
/// type.
void put_option(const OptionFacts& facts, OptionPlace place, const Json& value);

/// `options` with those rows of the table that `asked` names and a page may set; other names are
/// ignored. Throws as put_option().
template <class Fields, class Options>
Options with_options(const Fields& fields, Options options, const Json& asked) {
  for (const auto& field : fields)
    if (const auto value = asked.find(field.name); field.users.page && value != asked.end())
      put_option(field, field.place(options), *value);
  return options;
}

/// `options` with the settings of the session that `fields` names.
RunOptions with_settings(RunOptions options, const Json& fields);

/// Whether an option of a run has no meaning here: the number of steps, and which are shown.
bool is_no_setting(const RunField& field);

/// All present settings.
Json settings_of(const RunOptions& options);

}  // namespace pliant::play
