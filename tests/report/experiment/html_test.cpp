#include "report/experiment/html.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cellsweep::report {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(Html, MakesWordsHarmless) {
  EXPECT_EQ(html_text("a<b> & \"c\""), "a&lt;b&gt; &amp; &quot;c&quot;");
  EXPECT_THAT(html_table({{"<script>"}, {"&"}}), HasSubstr("<th>&lt;script&gt;</th>"));
}

TEST(Html, TakesAnSvgFileInWithoutTheAddressesOfItsFormat) {
  const std::string svg = inline_svg(
      "<?xml version=\"1.0\"?>\n<!DOCTYPE svg PUBLIC \"x\" \"http://www.w3.org/dtd\">\n"
      "<svg width=\"9\"\n xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink='http://www.w3.org/1999/xlink'>"
      "<use xlink:href='#p'/></svg>\n",
      "a <figure>");
  EXPECT_EQ(svg,
            "<svg role=\"img\" aria-label=\"a &lt;figure&gt;\" width=\"9\"><use xlink:href='#p'/></svg>\n");
  EXPECT_EQ(inline_svg("no picture at all", ""), "");
}

TEST(Html, WritesBase64OfEveryLength) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
}

}  // namespace
}  // namespace cellsweep::report
