// SPDX-License-Identifier: MIT
// Settings of the session as JSON: rows of run_fields(), by name.
#pragma once

#include "pliant/run/run_fields.hpp"
#include "reply.hpp"

namespace pliant::play {

/// Puts a JSON value into the place of an option. A seed may be text. Throws OptionError for a
/// value of another kind.
void put_option(const OptionFacts& facts, OptionPlace place, const Json& value);

/// `options` with those of the table that `asked` names and a page may set; other names are left
/// alone. Throws as put_option().
template <class Fields, class Options>
Options with_options(const Fields& fields, Options options, const Json& asked) {
  for (const auto& field : fields)
    if (const auto value = asked.find(field.name); field.users.page && value != asked.end())
      put_option(field, field.place(options), *value);
  return options;
}

/// The settings of the session with those that `fields` names.
RunOptions with_settings(RunOptions options, const Json& fields);

/// Whether an option of a run means nothing here: how many steps, which are shown.
bool is_no_setting(const RunField& field);

/// All settings in force.
Json settings_of(const RunOptions& options);

}  // namespace pliant::play
