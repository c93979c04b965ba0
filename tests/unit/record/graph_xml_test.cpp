// SPDX-License-Identifier: MIT
#include "pliant/record/xml/graph_xml.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/error.hpp"
#include "pliant/record/xml/write_graph_xml.hpp"
#include "support/error_text.hpp"

namespace pliant::graph_xml_test {

using testing::ElementsAre;
using testing::HasSubstr;

struct Heard {
  std::vector<std::string> warnings;
  Log log() {
    return {[this](Severity, std::string_view text) { warnings.emplace_back(text); }};
  }
};

GraphFile parse(std::string_view text, const Log& log = {}) {
  return parse_graph_xml({"g.xml", text}, log);
}

std::string error_of(std::string_view text) {
  return test::error_text<InputError>([&] { parse(text); });
}

std::string graph(std::string_view inside) {
  return "<graph>\n<joint id=\"a\" x=\"0\" y=\"0\" z=\"0\"/>\n<joint id=\"b\" x=\"1\" y=\"0\" "
         "z=\"0\"/>\n"
         "<joint id=\"c\" x=\"0\" y=\"1\" z=\"0\"/>\n" +
         std::string(inside) + "\n</graph>\n";
}

TEST(GraphXml, ReadsJointsBarsLengthsAndCycles) {
  const GraphFile g =
      parse(graph("<bar a='a' b='b'/><bar a='b' b='c' length='1.25'/><bar a='c' b='a'/>"
                  "<cycle joints='a b c'/>"));
  EXPECT_EQ(g.framework.joint_count(), 3u);
  EXPECT_THAT(g.framework.bars(), ElementsAre(Bar{0, 1}, Bar{1, 2}, Bar{2, 0}));
  EXPECT_THAT(g.framework.rest_lengths(), ElementsAre(1.0, 1.25, 1.0));
  EXPECT_THAT(g.cycles, ElementsAre(ElementsAre(0u, 1u, 2u)));
  EXPECT_EQ(g.framework.label(Joint{1}), "b");
  EXPECT_EQ(g.positions[2], (Vec3{0, 1, 0}));
}

TEST(GraphXml, ReadsMassesAndPins) {
  const GraphFile g = parse(
      "<graph><joint id='a' x='0' y='0' z='0' mass='4'/>"
      "<joint id='b' x='1' y='0' z='0' pinned='true'/></graph>");
  EXPECT_THAT(g.framework.inverse_masses(), ElementsAre(0.25, 0.0));
}

TEST(GraphXml, IsReadBackToTheSameBits) {
  const GraphFile g =
      parse(graph("<bar a='a' b='b' length='1.1000000000000001'/><bar a='b' b='c'/>"
                  "<bar a='c' b='a' length='0.30000000000000004'/><cycle joints='c a b'/>"));
  const std::string text = write_graph_xml(g.framework, g.positions, g.cycles);
  const GraphFile again = parse(text);
  EXPECT_EQ(again.positions, g.positions);
  EXPECT_EQ(again.cycles, g.cycles);
  EXPECT_EQ(write_graph_xml(again.framework, again.positions, again.cycles), text);
}

TEST(GraphXml, AcceptsAByteOrderMarkAFlatGraphAndALoneJoint) {
  EXPECT_TRUE(looks_like_xml("\xef\xbb\xbf <graph/>"));
  EXPECT_EQ(parse("<graph dimension='2'><joint id='a' x='1' y='2'/></graph>").positions[0],
            (Vec3{1, 2, 0}));
  EXPECT_EQ(parse("<graph><joint id='a' x='1' y='2' z='3'/></graph>").framework.bar_count(), 0u);
}

TEST(GraphXml, KeepsThatAGraphIsPlanar) {
  const GraphFile flat = parse(
      "<graph dimension='2'><joint id='a' x='1' y='2'/><joint id='b' x='1' y='2' z='3'/></graph>");
  EXPECT_TRUE(flat.framework.is_planar());
  EXPECT_EQ(write_graph_xml(flat.framework, flat.positions),
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<graph dimension=\"2\">\n"
            "  <joint id=\"a\" x=\"1\" y=\"2\"/>\n  <joint id=\"b\" x=\"1\" y=\"2\" z=\"3\"/>\n"
            "</graph>\n");
  for (const std::string dimension : {"", " dimension='3'"})
    EXPECT_FALSE(parse("<graph" + dimension + "><joint id='a' x='1' y='2' z='0'/></graph>")
                     .framework.is_planar());
}

TEST(GraphXml, MergesEqualBarsWithAWarning) {
  Heard heard;
  const GraphFile g =
      parse(graph("<bar a='a' b='b' length='1'/>\n<bar a='b' b='a' length='1'/>"), heard.log());
  EXPECT_EQ(g.framework.bar_count(), 1u);
  EXPECT_THAT(heard.warnings,
              ElementsAre("g.xml:6: bar \"b\" - \"a\" is given twice, first in line 5: merged"));
}

TEST(GraphXml, SaysWhichBarsCannotHoldTogether) {
  Heard heard;
  parse(graph("<bar a='a' b='b' length='1'/><bar a='b' b='c' length='1'/><bar a='a' b='c' "
              "length='5'/>"),
        heard.log());
  EXPECT_THAT(
      heard.warnings,
      ElementsAre("g.xml: bars a - b, b - c and a - c cannot hold together: 5 is longer than 1 and "
                  "1 together"));
}

struct Refused {
  const char* name;
  std::string text, message;
};

class GraphXmlRefuses : public testing::TestWithParam<Refused> {};

TEST_P(GraphXmlRefuses, NamingThePlace) {
  EXPECT_THAT(error_of(GetParam().text), HasSubstr(GetParam().message));
}

const Refused refused[] = {
    {"UnclosedRoot", "<graph>\n<joint id='a' x='0' y='0' z='0'/>", "g.xml:"},
    {"JointTwice", graph("<joint id='a' x='5' y='0' z='0'/>"),
     "g.xml:5: joint \"a\" is given twice, first in line 2"},
    {"UnknownJoint", graph("<bar a='a' b='zz'/>"), "g.xml:5: bar: no joint has the id \"zz\""},
    {"SelfLoop", graph("<bar a='a' b='a'/>"), "g.xml:5: bar \"a\" - \"a\" joins a joint to itself"},
    {"TwoLengths", graph("<bar a='a' b='b' length='1'/>\n<bar a='a' b='b' length='2'/>"),
     "g.xml:6: bar \"a\" - \"b\" is given twice, first in line 5: with the lengths 1 and 2"},
    {"ZeroLength", graph("<bar a='a' b='b' length='0'/>"),
     "expected a number above 0, found \"0\""},
    {"NegativeLength", graph("<bar a='a' b='b' length='-1'/>"),
     "expected a number above 0, found \"-1\""},
    {"Nan", "<graph>\n<joint id='a' x='nan' y='0' z='0'/></graph>",
     "g.xml:2: x: expected a finite number, found \"nan\""},
    {"Infinite", graph("<bar a='a' b='b' length='inf'/>"),
     "length: expected a finite number, found \"inf\""},
    {"NoZ", "<graph>\n<joint id='a' x='0' y='0'/></graph>", "g.xml:2: joint without attribute z"},
    {"OtherRoot", "<svg/>", "g.xml:1: expected the root element graph, found \"svg\""},
    {"NoJoints", "<graph></graph>", "g.xml: holds no joint"},
    {"Entities", "<!DOCTYPE g [<!ENTITY a 'aa'>]><graph/>",
     "g.xml:1: a document type (DTD) is not read"},
    {"ExternalEntity", "<!DOCTYPE g SYSTEM 'file:///etc/passwd'><graph/>",
     "a document type (DTD) is not read"},
    {"Depth",
     [] {
       std::string text = "<graph>";
       for (int i = 0; i < 200000; ++i) text += "<joint>";
       return text;
     }(),
     "elements are nested more than 64 deep"},
    {"LongId", "<graph>\n<joint id='" + std::string(2'000'000, 'x') + "' x='0' y='0'/></graph>",
     "g.xml:2: joint without attribute z"},
    {"NotUtf8", "<graph><joint id='\xff' x='0' y='0' z='0'/></graph>",
     "g.xml: byte 18 is not UTF-8 text"},
    {"Utf16", std::string("\xff\xfe<\0g\0", 6), "is UTF-16 text"},
    {"ControlCharacter", "<graph>\n<joint id='a&#27;[31m' x='0' y='0' z='0'/></graph>",
     "g.xml:2: id: blanks and control characters are not allowed, found \"a\\x1b[31m\""},
    {"DecimalComma", "<graph>\n<joint id='a' x='0,5' y='0' z='0'/></graph>",
     "x: expected a finite number"},
    {"TrailingText", "<graph>\n<joint id='a' x='1.0abc' y='0' z='0'/></graph>",
     "x: expected a finite number"},
    {"TwoRoots", "<graph><joint id='a' x='0' y='0' z='0'/></graph>\n<graph/>",
     "g.xml:2: expected one root element, found a second: \"graph\""},
    {"Gzip", std::string("\x1f\x8b\x08\0\0", 5), "g.xml"},
    {"UnknownElement", graph("<rod a='a' b='b'/>"),
     "g.xml:5: expected joint, bar or cycle, found \"rod\""},
    {"UnknownAttribute", graph("<bar a='a' b='b' lenght='2'/>"),
     "g.xml:5: bar: expected the attributes a, b or length, found \"lenght\""},
    {"AttributeTwice", graph("<bar a='a' b='b' b='c'/>"),
     "g.xml:5: bar: the attribute b is given twice"},
    {"ElementInAJoint", "<graph>\n<joint id='a' x='0' y='0' z='0'><bar/></joint></graph>",
     "g.xml:2: expected none, found \"bar\""},
    {"TextAmongElements", graph("3 bars follow"),
     "expected joint, bar or cycle, found \"3 bars follow\""},
    {"CycleWithoutBar", graph("<bar a='a' b='b'/><cycle joints='a b c'/>"),
     "cycle: no bar joins \"b\" and \"c\""},
};

INSTANTIATE_TEST_SUITE_P(Table, GraphXmlRefuses, testing::ValuesIn(refused),
                         [](const auto& row) { return row.param.name; });

}  // namespace pliant::graph_xml_test
