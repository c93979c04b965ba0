// SPDX-License-Identifier: MIT
#include "pliant/record/xml/graph_xml.hpp"

#include "pliant/record/xml/write_graph_xml.hpp"
#include "support/test.hpp"

namespace pliant::graph_xml_test {

GraphFile parse(std::string_view text) { return parse_graph_xml({"g.xml", text}); }

TEST(GraphXml, KeepsThatAGraphIsPlanar) {
  EXPECT_TRUE(looks_like_xml("\xef\xbb\xbf <graph/>"));
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

/// What is too large for a file of tests/corpus/graph, which holds the other refusals.
TEST(GraphXml, RefusesWhatIsTooDeepOrTooLong) {
  std::string deep = "<graph>";
  for (int i = 0; i < 200000; ++i) deep += "<joint>";
  const std::string long_id = std::string(2'000'000, 'x');
  const std::pair<std::string, const char*> cases[] = {
      {deep, "elements are nested more than 64 deep"},
      {"<graph>\n<joint id='" + long_id + "' x='0' y='0'/></graph>",
       "g.xml:2: joint without attribute z"},
      {"<graph>\n<joint id='a' x='0' y='0' z='0'><bar/></joint></graph>",
       "g.xml:2: expected none, found \"bar\""}};
  for (const auto& [text, message] : cases)
    EXPECT_THAT(test::error_text<InputError>([&] { parse(text); }), testing::HasSubstr(message));
}

}  // namespace pliant::graph_xml_test
