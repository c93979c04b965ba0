// SPDX-License-Identifier: MIT
#include "pliant/stream/imd_packets.hpp"

#include <gtest/gtest.h>

#include <bit>

#include "imd_client.hpp"

namespace pliant {
namespace imd_packets_test {

using test::bytes_of;
using test::operator+;

constexpr bool is_little = std::endian::native == std::endian::little;

/// A format whose bodies are of the least, or of the greatest byte first.
ImdFormat format(int version, bool least_first) { return {version, is_little != least_first}; }

const std::vector<Vec3> two_places{{1.0, -2.0, 0.5}, {0.0, 0.25, 1e-3}};

Frame a_frame() {
  Frame frame;
  frame.step = 258;
  frame.time = 2.58;
  frame.positions = two_places;
  frame.sweeps = 3;
  frame.max_residual = 0.5;
  frame.rms_residual = 0.25;
  frame.max_limit = 2.0;
  frame.max_overlap = 4.0;
  frame.stop = Stop::max_sweeps;
  return frame;
}

Bytes frame_bytes(const ImdFormat& how) {
  Bytes coordinates = bytes_of("ff");  // what was there goes
  imd_coordinates(how, a_frame().positions, coordinates);
  return imd_head(how, a_frame(), 0.01, {2, 8}) + coordinates;
}

TEST(ImdPackets, GreetAsTheSpecificationSays) {
  EXPECT_EQ(imd_greeting(format(2, true)), bytes_of("0000000402000000"));
  EXPECT_EQ(imd_greeting(format(2, false)), bytes_of("0000000400000002"));
  const Bytes session = bytes_of("0000000a00000007") + bytes_of("01010001000000");
  EXPECT_EQ(imd_greeting(format(3, true)), bytes_of("0000000403000000") + session);
  EXPECT_EQ(imd_greeting(format(3, false)), bytes_of("0000000400000003") + session);
}

// Energies: step 258; T 0, then 0.5, 0.25, 4, 1, 3, 2, 2 and 8 (as the table in README.md has it).
TEST(ImdPackets, FramesOfVersion2AreEnergiesAndCoordinates) {
  const Bytes head = bytes_of("0000000100000001"), next = bytes_of("0000000200000002");
  EXPECT_EQ(frame_bytes(format(2, false)),
            head +
                bytes_of("00000102"
                         "000000003f0000003e8000004080000"
                         "03f80000040400000400000004000000041000000") +
                next +
                bytes_of("3f800000c00000003f000000"
                         "000000003e8000003a83126f"));
  EXPECT_EQ(frame_bytes(format(2, true)), head +
                                              bytes_of("02010000"
                                                       "000000000000003f0000803e00008040"
                                                       "0000803f00004040000000400000004000000041") +
                                              next +
                                              bytes_of("0000803f000000c00000003f"
                                                       "000000000000803e6f12833a"));
}

TEST(ImdPackets, Version3HasTheTimeBefore) {
  // 0.01, 2.58 and 258 in eight bytes each.
  EXPECT_EQ(frame_bytes(format(3, false)),
            bytes_of("0000000c00000001"
                     "3f847ae147ae147b4004a3d70a3d70a40000000000000102") +
                frame_bytes(format(2, false)));
}

TEST(ImdPackets, LateStepsStayNumbers) {
  Frame frame = a_frame();
  frame.step = std::int64_t{1} << 40;
  const Bytes bytes = imd_head(format(2, false), frame, 0.01, {});
  EXPECT_EQ(Bytes(bytes.begin() + 8, bytes.begin() + 12), bytes_of("7fffffff"));
}

TEST(ImdPackets, ConvergedStepsAreTold) {
  Frame frame = a_frame();
  frame.stop = Stop::converged;
  EXPECT_EQ(imd_energies(frame, {}).coulomb, 0.0F);
  EXPECT_EQ(imd_energies(a_frame(), {}).coulomb, 1.0F);
}

TEST(ImdPackets, HeadersAreRead) {
  const ImdHeader header = imd_header(bytes_of("00000008fffffffe").data());
  EXPECT_EQ(header.type, ImdType::rate);
  EXPECT_EQ(header.value, -2);
}

}  // namespace imd_packets_test
}  // namespace pliant
