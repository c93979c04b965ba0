// SPDX-License-Identifier: MIT
#include "pliant/framework/fingerprint.hpp"

#include <gtest/gtest.h>

namespace pliant {
namespace fingerprint_test {

AtomTable two_atoms() {
  AtomTable atoms;
  atoms.names = {"C", "A1"};
  atoms.elements = {6, 0};
  atoms.residue_of = {0, 0};
  atoms.residues = {{"LIG", 1, ' ', "A"}};
  atoms.serials = {1, 2};
  return atoms;
}

const std::vector<Vec3> places{{1.0, 2.0, 3.0}, {-0.5, 0.0, 1e-300}};

/// The offset basis, and 1.0 as the bytes 00 00 00 00 00 00 f0 3f, worked out apart with Python's
/// whole numbers.
TEST(Fingerprint, IsFnv1aOfTheBytes) {
  EXPECT_EQ(fingerprint(std::span<const Vec3>{}), 0xcbf29ce484222325u);
  EXPECT_EQ(fingerprint_text(fingerprint(std::vector<Vec3>{{1.0, 0.0, 0.0}})), "bd85f5df2322cbb8");
}

TEST(Fingerprint, IsOfAnotherStructureWhereAnythingDiffers) {
  const std::uint64_t one = fingerprint(two_atoms(), places);
  AtomTable other = two_atoms();
  other.names = {"CA", "1"};
  EXPECT_NE(fingerprint(other, places), one);
  other = two_atoms();
  other.elements[0] = 7;
  EXPECT_NE(fingerprint(other, places), one);
  other = two_atoms();
  other.residues[0].name = "ALA";
  EXPECT_NE(fingerprint(other, places), one);
  std::vector<Vec3> moved = places;
  moved[1].y = -0.0;
  EXPECT_NE(fingerprint(two_atoms(), moved), one);
  other = two_atoms();
  other.residues[0].chain = "B";
  EXPECT_EQ(fingerprint(other, places), one);
}

}  // namespace fingerprint_test
}  // namespace pliant
