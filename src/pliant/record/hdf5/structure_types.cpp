// SPDX-License-Identifier: MIT
#include "pliant/record/hdf5/structure_types.hpp"

#include "pliant/record/hdf5/expansion.hpp"

namespace pliant {
namespace {

enum Class {
  fixed_point,
  floating,
  time_of_day,
  text,
  bits,
  opaque,
  compound,
  reference,
  enumeration,
  variable,
  array
};

constexpr int most_levels = 8;
constexpr std::uint64_t most_members = 4096;
constexpr std::uint64_t most_bytes = std::uint64_t{1} << 32;
constexpr std::uint64_t heap_reference_bytes = 16;

/// The first eight bytes of every datatype.
struct TypeHead {
  std::uint64_t version, type_class, flags, bytes;
};

TypeHead read_head(StructureFields& fields) {
  const std::uint64_t first = fields.number(1);
  TypeHead head{first >> 4, first & 15, fields.number(3), fields.number(4)};
  if (head.version == 4 || head.version == 5) throw UnknownDatatype();  // HDF5 1.12 and 2.0
  fields.require(head.version >= 1 && head.version <= 3, "datatype of an unknown version");
  fields.require(head.type_class <= array, "datatype of an unknown class");
  fields.require(head.bytes > 0 && head.bytes < most_bytes, "datatype of an impossible size");
  return head;
}

void check_bits(StructureFields& fields, std::uint64_t bytes) {
  const std::uint64_t offset = fields.number(2), precision = fields.number(2);
  fields.require(precision > 0 && offset + precision <= 8 * bytes && bytes <= 64,
                 "number with bits outside of it");
}

void check_floating(StructureFields& fields, const TypeHead& head) {
  const std::uint64_t offset = fields.number(2), precision = fields.number(2);
  const std::uint64_t exponent = fields.number(1), exponent_bits = fields.number(1);
  const std::uint64_t mantissa = fields.number(1), mantissa_bits = fields.number(1);
  const std::uint64_t sign = head.flags >> 8 & 255, end = offset + precision;
  fields.skip(4);  // bias of the exponent
  const bool apart = exponent >= mantissa + mantissa_bits || mantissa >= exponent + exponent_bits;
  fields.require(head.bytes <= 64 && precision > 0 && end <= 8 * head.bytes && sign < end &&
                     exponent + exponent_bits <= end && mantissa + mantissa_bits <= end &&
                     exponent_bits > 0 && mantissa_bits > 0 && apart && exponent_bits <= 32 &&
                     (head.flags >> 4 & 3) != 3,
                 "floating-point number with bits outside of it");
}

void pass_name(StructureFields& fields, std::uint64_t version) {
  const std::size_t start = fields.position();
  fields.text();
  const std::size_t length = fields.position() - start;
  if (version < 3) fields.skip((8 - length % 8) % 8);
}

std::size_t width_of(std::uint64_t most) {
  std::size_t width = 1;
  while (most >>= 8) ++width;
  return width;
}

TypeFacts check_compound(StructureFields& fields, const TypeHead& head, int level) {
  const std::uint64_t members = head.flags & 0xffff;
  fields.require(members > 0 && members <= most_members, "compound of too few or many members");
  TypeFacts facts{head.bytes};
  for (std::uint64_t k = 0; k < members; ++k) {
    pass_name(fields, head.version);
    const std::uint64_t offset = fields.number(head.version < 3 ? 4 : width_of(head.bytes));
    if (head.version == 1) {
      fields.require(fields.number(1) == 0, "compound with arrays of version 1");
      fields.skip(27);
    }
    const TypeFacts member = check_datatype(fields, level + 1);
    fields.require(offset <= head.bytes && member.bytes <= head.bytes - offset,
                   "compound with a member outside of it");
    facts.has_variable_parts |= member.is_variable || member.has_variable_parts;
  }
  return facts;
}

TypeFacts check_enumeration(StructureFields& fields, const TypeHead& head, int level) {
  const std::uint64_t members = head.flags & 0xffff;
  const TypeFacts base = check_datatype(fields, level + 1);
  fields.require(base.bytes == head.bytes && base.bytes <= 8 && !base.is_variable,
                 "enumeration of another size than its numbers");
  fields.require(members <= most_members, "enumeration of too many names");
  for (std::uint64_t k = 0; k < members; ++k) pass_name(fields, head.version);
  fields.skip(members * base.bytes);
  return {head.bytes};
}

TypeFacts check_variable(StructureFields& fields, const TypeHead& head, int level) {
  fields.require((head.flags & 15) <= 1 && head.bytes == heap_reference_bytes,
                 "variable-length type of an unknown kind");
  const TypeFacts base = check_datatype(fields, level + 1);
  fields.require((head.flags & 15) == 0 || base.bytes == 1, "text of letters of several bytes");
  return {head.bytes, true, base.bytes, base.is_variable || base.has_variable_parts};
}

TypeFacts check_array(StructureFields& fields, const TypeHead& head, int level) {
  const std::uint64_t rank = fields.number(1);
  fields.require(rank > 0 && rank <= 32, "array of too few or many extents");
  if (head.version < 3) fields.skip(3);
  std::uint64_t count = 1;
  for (std::uint64_t k = 0; k < rank; ++k) {
    const std::uint64_t extent = fields.number(4);
    fields.require(extent > 0 && extent <= most_bytes / count, "array of an impossible extent");
    count *= extent;
  }
  if (head.version < 3) fields.skip(4 * rank);
  const TypeFacts base = check_datatype(fields, level + 1);
  fields.require(base.bytes * count == head.bytes, "array of another size than its values");
  return {head.bytes, false, 0, base.is_variable || base.has_variable_parts};
}

}  // namespace

TypeFacts check_datatype(StructureFields& fields, int level) {
  fields.require(level < most_levels, "datatype of too many levels");
  const TypeHead head = read_head(fields);
  switch (head.type_class) {
    case fixed_point:
    case bits:
      check_bits(fields, head.bytes);
      return {head.bytes};
    case floating:
      check_floating(fields, head);
      return {head.bytes};
    case time_of_day:
      fields.skip(2);
      return {head.bytes};
    case text:
      fields.require((head.flags & 15) <= 2 && (head.flags >> 4 & 15) <= 1,
                     "text of an unknown kind");
      return {head.bytes};
    case opaque:
      fields.skip(head.flags & 255);
      return {head.bytes};
    case compound:
      return check_compound(fields, head, level);
    case reference:
      fields.require((head.flags & 15) <= 1 && (head.bytes == 8 || head.bytes == 12),
                     "reference of an unknown kind");
      return {head.bytes};
    case enumeration:
      return check_enumeration(fields, head, level);
    case variable:
      return check_variable(fields, head, level);
    default:
      return check_array(fields, head, level);
  }
}

SpaceFacts check_dataspace(StructureFields& fields) {
  const std::uint64_t version = fields.number(1), rank = fields.number(1);
  const std::uint64_t flags = fields.number(1), kind = fields.number(1);
  fields.require(version == 1 || version == 2, "dataspace of an unknown version");
  fields.require(rank <= 32 && flags <= 1, "dataspace with too many extents");
  if (version == 1) fields.skip(4);
  fields.require(version == 1 || (kind <= 2 && (kind == 1 || rank == 0)),
                 "dataspace of an unknown kind");
  SpaceFacts facts;
  for (std::uint64_t k = 0; k < rank; ++k) {
    facts.extents.push_back(fields.number(8));
    facts.count = times(facts.count, facts.extents.back());
  }
  for (std::uint64_t k = 0; k < rank && flags == 1; ++k)
    fields.require(fields.number(8) >= facts.extents[k], "dataspace beyond its limit");
  if (version == 2 && kind == 2) facts.count = 0;
  return facts;
}

}  // namespace pliant
