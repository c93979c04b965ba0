// SPDX-License-Identifier: MIT
#include "pliant/record/hdf5/structure_messages.hpp"

#include <algorithm>
#include <string>

#include "pliant/record/hdf5/structure_trees.hpp"

namespace pliant {
namespace {

constexpr std::uint64_t shared_flag = 2;
constexpr std::uint64_t deflate = 1, shuffle = 2, fletcher32 = 3;

template <class T>
void set_once(std::optional<T>& place, T value, const StructureFields& fields) {
  fields.require(!place, "comes twice");
  place = std::move(value);
}

void add_link_info(StructureWalk& walk, StructureFields fields, ObjectFacts& facts) {
  facts.has_links = true;
  fields.require(fields.number(1) == 0, "is of an unknown version");
  const std::uint64_t flags = fields.number(1);
  fields.require(flags <= 3, "has unknown flags");
  if ((flags & 1) != 0) fields.skip(8);
  const std::uint64_t heap = fields.number(8);
  fields.skip(8);
  if (heap != no_address) walk.leave_unchecked();  // links in a heap and a tree of their own
}

void add_link(StructureWalk& walk, StructureFields fields, ObjectFacts& facts) {
  facts.has_links = true;
  fields.require(fields.number(1) == 1, "is of an unknown version");
  const std::uint64_t flags = fields.number(1);
  fields.require(flags < 32, "has unknown flags");
  const std::uint64_t kind = (flags & 8) != 0 ? fields.number(1) : 0;
  if ((flags & 4) != 0) fields.skip(8);
  if ((flags & 16) != 0) fields.require(fields.number(1) <= 1, "is in an unknown alphabet");
  const std::uint64_t length = fields.number(std::size_t{1} << (flags & 3));
  fields.require(length > 0, "has no name");
  fields.skip(length);
  if (kind == 0) {
    walk.visit_later(fields.number(8));
  } else {
    fields.require(kind == 1 || kind == 64, "is of an unknown kind");
    const std::uint64_t bytes = fields.number(2);
    fields.require(bytes > 0, "leads nowhere");
    StructureFields target = fields.part(bytes, "target");
    if (kind == 64) {
      target.require(target.number(1) == 0, "is of an unknown version");
      target.text();
      target.text();
    }
  }
}

std::uint64_t sized_fill(StructureFields& fields) {
  const std::uint64_t bytes = fields.number(4);
  if (bytes == 0xffffffff) return 0;
  fields.skip(bytes);
  return bytes;
}

void add_fill(StructureFields fields, ObjectFacts& facts) {
  const std::uint64_t version = fields.number(1);
  fields.require(version >= 1 && version <= 3, "is of an unknown version");
  if (version == 3) {
    const std::uint64_t flags = fields.number(1);
    fields.require(flags < 64, "has unknown flags");
    set_once(facts.fill_bytes, (flags & 32) != 0 ? sized_fill(fields) : 0, fields);
    return;
  }
  fields.require(fields.number(1) <= 3 && fields.number(1) <= 2, "has an unknown time");
  const std::uint64_t is_defined = fields.number(1);
  fields.require(is_defined <= 1, "is neither defined nor undefined");
  set_once(facts.fill_bytes, version == 1 || is_defined == 1 ? sized_fill(fields) : 0, fields);
}

LayoutFacts read_chunked(StructureFields& fields) {
  LayoutFacts layout;
  layout.kind = LayoutFacts::chunked;
  const std::uint64_t rank = fields.number(1);
  fields.require(rank >= 2 && rank <= 33, "has chunks of too few or many extents");
  layout.address = fields.number(8);
  std::uint64_t bytes = 1;
  for (std::uint64_t k = 0; k < rank; ++k) {
    layout.extents.push_back(fields.number(4));
    fields.require(layout.extents.back() > 0, "has chunks without values");
    fields.require(layout.extents.back() <= 0xffffffff / bytes, "has chunks that are too large");
    bytes *= layout.extents.back();
  }
  layout.bytes = bytes;
  return layout;
}

LayoutFacts read_layout(StructureWalk& walk, StructureFields& fields) {
  const std::uint64_t version = fields.number(1);
  fields.require(version >= 1 && version <= 5, "is of an unknown version");
  const std::uint64_t kind = fields.number(1);
  fields.require(version < 3 || kind <= 3, "is of an unknown kind");
  LayoutFacts layout;
  if (version < 3 || (version > 3 && kind >= 2) || kind == 3) {
    walk.leave_unchecked();
  } else if (kind == 0) {
    layout.kind = LayoutFacts::compact;
    layout.bytes = fields.number(2);
    const auto values = fields.part(layout.bytes, "values").all();
    layout.values.assign(values.begin(), values.end());
  } else if (kind == 1) {
    layout.kind = LayoutFacts::contiguous;
    layout.address = fields.number(8);
    layout.bytes = fields.number(8);
  } else {
    layout = read_chunked(fields);
  }
  return layout;
}

void add_filters(StructureWalk& walk, StructureFields fields, ObjectFacts& facts) {
  const std::uint64_t version = fields.number(1), count = fields.number(1);
  fields.require(version == 1 || version == 2, "is of an unknown version");
  fields.require(count > 0 && count <= 32 && !facts.is_filtered, "has too few or many filters");
  facts.is_filtered = true;
  if (version == 1) fields.skip(6);
  for (std::uint64_t k = 0; k < count; ++k) {
    const std::uint64_t id = fields.number(2);
    const std::uint64_t name = version == 1 || id >= 256 ? fields.number(2) : 0;
    fields.require(fields.number(2) <= 1, "has a filter with unknown flags");
    const std::uint64_t values = fields.number(2);
    fields.skip(version == 1 ? (name + 7) / 8 * 8 : name);
    fields.skip(4 * (version == 1 && values % 2 == 1 ? values + 1 : values));
    if (id != deflate && id != shuffle && id != fletcher32) walk.leave_unchecked();
  }
}

/// Version 1 pads its parts.
StructureFields padded_part(StructureFields& fields, std::uint64_t bytes, std::uint64_t version,
                            const char* what) {
  StructureFields part = fields.part(bytes, what);
  if (version == 1) fields.skip((8 - bytes % 8) % 8);
  return part;
}

void check_attribute(StructureWalk& walk, StructureFields fields) {
  const std::uint64_t version = fields.number(1), flags = fields.number(1);
  fields.require(version >= 1 && version <= 3, "is of an unknown version");
  const std::uint64_t name_bytes = fields.number(2), type_bytes = fields.number(2);
  const std::uint64_t space_bytes = fields.number(2);
  if (version == 3) fields.require(fields.number(1) <= 1, "is in an unknown alphabet");
  StructureFields name = padded_part(fields, name_bytes, version, "name");
  name.require(name.text().size() + 1 == name_bytes, "has not the length that is stated");
  StructureFields type_part = padded_part(fields, type_bytes, version, "datatype");
  StructureFields space_part = padded_part(fields, space_bytes, version, "dataspace");
  if (version > 1 && flags != 0) return walk.leave_unchecked();  // a type that others share
  const TypeFacts type = check_datatype(type_part);
  const SpaceFacts space = check_dataspace(space_part);
  fields.require(space.count <= fields.left() / type.bytes, "has fewer values than it states");
  if (type.has_variable_parts) walk.leave_unchecked();
  if (type.is_variable)
    check_heap_references(walk, fields.part(space.count * type.bytes, "values").all(),
                          type.item_bytes);
}

void check_attribute_info(StructureWalk& walk, StructureFields fields) {
  fields.require(fields.number(1) == 0, "is of an unknown version");
  const std::uint64_t flags = fields.number(1);
  fields.require(flags <= 3, "has unknown flags");
  if ((flags & 1) != 0) fields.skip(2);
  if (fields.number(8) != no_address) walk.leave_unchecked();
}

void check_variable_values(StructureWalk& walk, const ObjectFacts& facts) {
  constexpr std::uint64_t most = std::uint64_t{1} << 26;
  const LayoutFacts& layout = *facts.layout;
  if (layout.kind == LayoutFacts::compact)
    return check_heap_references(walk, layout.values, facts.type->item_bytes);
  if (layout.kind != LayoutFacts::contiguous || layout.bytes > most) return walk.leave_unchecked();
  if (layout.address == no_address) return;
  check_heap_references(walk, walk.read(layout.address, layout.bytes), facts.type->item_bytes);
}

void check_chunks(StructureWalk& walk, const ObjectFacts& facts, const StructureFields& header) {
  const LayoutFacts& layout = *facts.layout;
  header.require(layout.extents.size() == facts.space->extents.size() + 1 &&
                     layout.extents.back() == facts.type->bytes,
                 "has chunks of another shape than its values");
  ChunkFacts chunk{
      {layout.extents.begin(), layout.extents.end() - 1}, layout.bytes, facts.is_filtered};
  if (layout.address != no_address) check_chunk_tree(walk, layout.address, chunk);
}

/// Kinds of messages, as numbered in the file.
enum MessageKind : std::uint64_t {
  nothing,
  dataspace,
  link_info,
  datatype,
  old_fill,
  fill,
  link,
  layout = 8,
  group_info = 10,
  filters,
  attribute,
  comment,
  old_time,
  continuation = 16,
  symbol_table,
  time,
  attribute_info = 21,
  references
};

void add_group_message(StructureWalk& walk, const HeaderMessage& message, ObjectFacts& facts) {
  StructureFields fields = message.fields;
  if (message.type == link_info) return add_link_info(walk, fields, facts);
  if (message.type == link) return add_link(walk, fields, facts);
  facts.has_links = true;
  const std::uint64_t tree = fields.number(8);
  walk.visit_later({tree, fields.number(8)});
}

void add_known_message(StructureWalk& walk, const HeaderMessage& message, ObjectFacts& facts) {
  StructureFields fields = message.fields;
  switch (message.type) {
    case dataspace:
      return set_once(facts.space, check_dataspace(fields), fields);
    case datatype:
      return set_once(facts.type, check_datatype(fields), fields);
    case link_info:
    case link:
    case symbol_table:
      return add_group_message(walk, message, facts);
    case old_fill:
      return static_cast<void>(sized_fill(fields));
    case fill:
      return add_fill(fields, facts);
    case layout:
      return set_once(facts.layout, read_layout(walk, fields), fields);
    case filters:
      return add_filters(walk, fields, facts);
    case attribute:
      return check_attribute(walk, fields);
    case attribute_info:
      return check_attribute_info(walk, fields);
    case nothing:
    case group_info:
    case comment:
    case old_time:
    case continuation:
    case time:
    case references:
      return;
    default:
      fields.require(message.type <= 0x17, "is of an unknown kind");
      walk.leave_unchecked();
  }
}

}  // namespace

void add_message(StructureWalk& walk, const HeaderMessage& message, ObjectFacts& facts) {
  try {
    if ((message.flags & shared_flag) == 0) return add_known_message(walk, message, facts);
  } catch (const UnknownDatatype&) {
    message.fields.require(message.has_checksum, "datatype of an unknown version");
  }
  facts.is_unchecked = true;
  walk.leave_unchecked();
}

void check_object_facts(StructureWalk& walk, const ObjectFacts& facts,
                        const StructureFields& header) {
  if (facts.is_unchecked) return;
  if (!facts.layout) {
    header.require(facts.has_links || facts.type, "is neither group, dataset nor datatype");
    return;
  }
  header.require(facts.space && facts.type && !facts.has_links, "is half a dataset");
  const std::uint64_t fill = facts.fill_bytes.value_or(0);
  header.require(fill == 0 || fill == facts.type->bytes, "has a fill value of another type");
  const LayoutFacts& layout = *facts.layout;
  if (facts.type->has_variable_parts) walk.leave_unchecked();
  if (layout.kind == LayoutFacts::unknown) return;
  if (layout.kind == LayoutFacts::chunked) {
    check_chunks(walk, facts, header);
  } else {
    header.require(facts.space->count <= layout.bytes / facts.type->bytes &&
                       facts.space->count * facts.type->bytes == layout.bytes,
                   "has values of another size than it states");
    if (layout.kind == LayoutFacts::contiguous && layout.address != no_address && layout.bytes > 0)
      walk.take_values(layout.address, layout.bytes, "values");
  }
  if (facts.type->is_variable) check_variable_values(walk, facts);
}

}  // namespace pliant
