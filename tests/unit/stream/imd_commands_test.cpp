// SPDX-License-Identifier: MIT
#include "pliant/stream/imd_commands.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "imd_client.hpp"
#include "support/error_text.hpp"

namespace pliant {
namespace imd_commands_test {

using test::bytes_of;
using test::operator+;
using test::packet;

constexpr std::size_t atoms = 5;

std::vector<ImdCommand> read(const Bytes& bytes, int version = 3) {
  ImdCommandReader reader({version, false}, atoms);
  reader.take(bytes);
  std::vector<ImdCommand> commands;
  while (auto command = reader.next()) commands.push_back(*command);
  return commands;
}

std::string refusal(const Bytes& bytes, int version = 3) {
  return test::error_text<InputError>([&] { read(bytes, version); });
}

TEST(ImdCommands, AreReadInAnyPieces) {
  const Bytes all = packet(ImdType::go) + packet(ImdType::rate, 7) +
                    test::forces(2, {4, 0}, {1, 2, 3, -4, 5, 6.5}) + packet(ImdType::kill);
  ImdCommandReader reader({3, false}, atoms);
  std::vector<ImdCommand> commands;
  for (const std::byte one : all) {
    reader.take({&one, 1});
    while (auto command = reader.next()) commands.push_back(*command);
  }
  EXPECT_FALSE(reader.is_within_packet());
  ASSERT_EQ(commands.size(), 4u);
  EXPECT_EQ(commands[0].type, ImdType::go);
  EXPECT_EQ(commands[1].type, ImdType::rate);
  EXPECT_EQ(commands[1].value, 7);
  ASSERT_EQ(commands[2].forces.size(), 2u);
  EXPECT_EQ(commands[2].forces[0].joint, 4u);
  EXPECT_EQ(commands[2].forces[0].force, (Vec3{1, 2, 3}));
  EXPECT_EQ(commands[2].forces[1].joint, 0u);
  EXPECT_EQ(commands[2].forces[1].force, (Vec3{-4, 5, 6.5}));
  EXPECT_EQ(commands[3].type, ImdType::kill);
}

TEST(ImdCommands, OfVersion2AreInKilocalories) {
  const auto commands = read(test::forces(1, {3}, {1, 0, -2}), 2);
  ASSERT_EQ(commands.size(), 1u);
  EXPECT_EQ(commands[0].forces[0].force, (Vec3{4.184, 0, -8.368}));
}

TEST(ImdCommands, AreReadInTheOtherByteOrder) {
  ImdCommandReader reader({3, true}, atoms);
  Bytes swapped = packet(ImdType::forces, 1);
  const Bytes body = test::forces(1, {3}, {1.5F, 0, -2});
  for (std::size_t k = 8; k < body.size(); k += 4)
    for (std::size_t b = 4; b-- > 0;) swapped.push_back(body[k + b]);
  reader.take(swapped);
  const auto command = reader.next();
  ASSERT_TRUE(command);
  EXPECT_EQ(command->forces[0].joint, 3u);
  EXPECT_EQ(command->forces[0].force, (Vec3{1.5, 0, -2}));
}

TEST(ImdCommands, MayPullAtNothing) {
  const auto commands = read(packet(ImdType::forces, 0));
  ASSERT_EQ(commands.size(), 1u);
  EXPECT_TRUE(commands[0].forces.empty());
}

TEST(ImdCommands, ThatAreNoneAreRefused) {
  const auto no_command = [](int type, int version) {
    return "packet of type " + std::to_string(type) + ", which no client of IMD version " +
           std::to_string(version) + " sends";
  };
  Bytes http;
  for (const char letter : std::string("GET / HTTP/1.1\r\n\r\n")) http.push_back(std::byte(letter));
  EXPECT_EQ(refusal(http), no_command(0x47455420, 3));
  EXPECT_EQ(refusal(bytes_of("ffffffff00000000")), no_command(-1, 3));
  EXPECT_EQ(refusal(bytes_of("0000001100000000")), no_command(17, 3));
  for (const ImdType type : {ImdType::energies, ImdType::coordinates, ImdType::handshake,
                             ImdType::io_error, ImdType::session_info, ImdType::time, ImdType::box,
                             ImdType::velocities, ImdType::all_forces})
    EXPECT_EQ(refusal(packet(type)), no_command(int(type), 3));
  EXPECT_EQ(refusal(packet(ImdType::resume), 2), no_command(11, 2));
  EXPECT_EQ(refusal(packet(ImdType::wait, 1), 2), no_command(16, 2));
}

TEST(ImdCommands, OfImpossibleForcesAreRefusedBeforeTheyHaveCome) {
  EXPECT_EQ(refusal(packet(ImdType::forces, -1)), "forces on -1 atoms of 5");
  EXPECT_EQ(refusal(packet(ImdType::forces, 6)), "forces on 6 atoms of 5");
  EXPECT_EQ(refusal(packet(ImdType::forces, std::numeric_limits<std::int32_t>::max())),
            "forces on 2147483647 atoms of 5");
}

TEST(ImdCommands, OfWrongForcesAreRefused) {
  EXPECT_EQ(refusal(test::forces(1, {5}, {0, 0, 0})), "force on atom 5 of 5");
  EXPECT_EQ(refusal(test::forces(1, {-1}, {0, 0, 0})), "force on atom -1 of 5");
  EXPECT_EQ(refusal(test::forces(2, {1, 1}, {0, 0, 0, 0, 0, 0})), "two forces on atom 1");
  EXPECT_EQ(refusal(test::forces(1, {2}, {0, NAN, 0})), "force on atom 2 is not finite");
  EXPECT_EQ(refusal(test::forces(1, {2}, {0, 0, -INFINITY})), "force on atom 2 is not finite");
}

TEST(ImdCommands, HalfOfOneIsNone) {
  ImdCommandReader reader({3, false}, atoms);
  reader.take(bytes_of("00000003"));
  EXPECT_FALSE(reader.next());
  EXPECT_TRUE(reader.is_within_packet());
  Bytes forces = test::forces(1, {1}, {1, 2, 3});
  forces.pop_back();
  ImdCommandReader other({3, false}, atoms);
  other.take(forces);
  EXPECT_FALSE(other.next());
  EXPECT_TRUE(other.is_within_packet());
}

}  // namespace imd_commands_test
}  // namespace pliant
