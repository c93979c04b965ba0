// SPDX-License-Identifier: MIT
#include "pliant/stream/imd_exchange.hpp"

#include "imd_client.hpp"
#include "pliant/stream/imd_commands.hpp"
#include "pliant/stream/imd_packets.hpp"
#include "support/test.hpp"

namespace pliant::imd_exchange_test {

using namespace test;

/// Without sockets, in one thread: where the run would have to wait, it counts that and goes on.
class ImdExchanges : public testing::Test {
 protected:
  bool has_waited() {
    const int before = waits_;
    exchange_.wants(1);
    return waits_ > before;
  }

  int waits_ = 0;
  std::shared_ptr<Steering> steering_ = std::make_shared<Steering>();
  ImdExchange exchange_{{.should_stop = [this] { return ++waits_ > 0; }}, steering_};
};

TEST_F(ImdExchanges, HoldTheRunAsLongAsOneClientHasPausedIt) {
  ImdFollower& one = exchange_.begin_client();
  ImdFollower& other = exchange_.begin_client();
  EXPECT_FALSE(has_waited());
  exchange_.pause(one, true);
  exchange_.pause(other, true);
  EXPECT_TRUE(has_waited());
  exchange_.pause(one, false);
  EXPECT_TRUE(has_waited()) << "the other has not said RESUME";
  exchange_.end_client(other);
  EXPECT_FALSE(has_waited()) << "who leaves holds nothing";
}

TEST_F(ImdExchanges, HaveARateForEachClient) {
  ImdFollower& often = exchange_.begin_client();
  ImdFollower& seldom = exchange_.begin_client();
  exchange_.set_rate(often, 2);
  exchange_.set_rate(seldom, 3);
  exchange_.set_ready(often);
  exchange_.set_ready(seldom);
  EXPECT_FALSE(exchange_.wants(1));
  EXPECT_TRUE(exchange_.wants(2));
  exchange_.put(exchange_.buffer(), [](const ImdCounts&) { return Bytes(1); });
  EXPECT_EQ(often.frames.size(), 1u);
  EXPECT_TRUE(seldom.frames.empty());
  EXPECT_TRUE(exchange_.wants(3));
  EXPECT_FALSE(exchange_.wants(4)) << "a frame waits for it already";
}

TEST_F(ImdExchanges, TellEachClientOfItselfAlone) {
  ImdFollower& slow = exchange_.begin_client();
  ImdFollower& quick = exchange_.begin_client();
  exchange_.set_ready(quick);
  exchange_.wants(1);
  exchange_.set_ready(slow);
  exchange_.wants(2);
  exchange_.pull(quick, {{3, {1, 0, 0}}});
  std::vector<std::string> said;
  exchange_.put(exchange_.buffer(), [&](const ImdCounts& counts) {
    said.push_back(std::to_string(counts.forces) + " " + std::to_string(counts.dropped));
    return Bytes{};
  });
  EXPECT_EQ(said, (std::vector<std::string>{"0 1", "1 0"}));
}

TEST_F(ImdExchanges, MakeTheCoordinatesOnceForAll) {
  for (int k = 0; k < 3; ++k) exchange_.set_ready(exchange_.begin_client());
  ASSERT_TRUE(exchange_.wants(1));
  const auto coordinates = exchange_.buffer();
  exchange_.put(coordinates, [](const ImdCounts&) { return Bytes{}; });
  EXPECT_EQ(coordinates.use_count(), 4);
}

TEST_F(ImdExchanges, TellAtMostAHundredWarnings) {
  for (int k = 0; k < 200; ++k) exchange_.refuse("no " + std::to_string(k));
  std::vector<std::string> said;
  exchange_.tell({[&](Severity, std::string_view text) { said.emplace_back(text); }});
  ASSERT_EQ(said.size(), 100u);
  EXPECT_EQ(said[99], "no 99; further ones are only counted");
  EXPECT_EQ(exchange_.summary().refused, 200);
}

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

TEST(ImdCommands, OfWrongForcesAreRefusedThoseOfImpossibleNumbersBeforeTheyHaveCome) {
  const std::pair<const char*, Bytes> cases[] = {
      {"forces on -1 atoms of 5", packet(ImdType::forces, -1)},
      {"forces on 6 atoms of 5", packet(ImdType::forces, 6)},
      {"forces on 2147483647 atoms of 5", packet(ImdType::forces, 2147483647)},
      {"force on atom 5 of 5", test::forces(1, {5}, {0, 0, 0})},
      {"force on atom -1 of 5", test::forces(1, {-1}, {0, 0, 0})},
      {"two forces on atom 1", test::forces(2, {1, 1}, {0, 0, 0, 0, 0, 0})},
      {"force on atom 2 is not finite", test::forces(1, {2}, {0, NAN, 0})},
      {"force on atom 2 is not finite", test::forces(1, {2}, {0, 0, -INFINITY})}};
  for (const auto& [text, bytes] : cases) EXPECT_EQ(refusal(bytes), text);
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

}  // namespace pliant::imd_exchange_test
