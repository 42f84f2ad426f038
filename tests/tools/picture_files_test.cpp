// PNG and PDF of a picture: their sizes, and what happens to text that is no picture.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>

#include "libplan/world/read_map.hpp"
#include "tools/picture_files.hpp"
#include "tools/render/automaton_picture.hpp"
#include "tools/render/page.hpp"
#include "tools/shell/data_directory.hpp"
#include "tools/shell/exit_code.hpp"

namespace waymark::tools {
namespace {

class Pictures : public ::testing::Test {
 protected:
  void SetUp() override {
    if (helper("waymark-convert").empty()) GTEST_SKIP() << "waymark-convert is not built";
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::string in(const std::string& name) const { return (folder_ / name).string(); }
  static std::string read(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

 private:
  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("waymark-pictures-" + std::to_string(::getpid()));
};

std::size_t big_endian(const std::string& bytes, std::size_t at) {
  std::size_t value = 0;
  for (std::size_t i = at; i < at + 4; ++i) value = value << 8U | static_cast<unsigned char>(bytes.at(i));
  return value;
}

struct Size {
  double width = 0, height = 0;
};
Size size_of(const std::string& svg) {
  std::smatch size;
  if (!std::regex_search(svg, size, std::regex("viewBox=\"0 0 ([0-9.]+) ([0-9.]+)\""))) return {};
  return {std::stod(size[1]), std::stod(size[2])};
}

TEST_F(Pictures, OfEveryShippedMapHaveTheSizeOfTheSvg) {
  for (const std::string& name : plan::shipped_maps(WAYMARK_DATA_FOLDER)) {
    const plan::Map map = plan::read_map(name, WAYMARK_DATA_FOLDER);
    render::Page page;
    page.map = &map;
    const std::string svg = render::draw_page(page);
    const Size size = size_of(svg);
    ASSERT_GT(size.width, 0);
    for (const double scale : {0.5, 1.0, 2.0}) {
      write_picture(svg, {.svg = in("a.svg"), .png = in("a.png"), .pdf = in("a.pdf"), .scale = scale});
      EXPECT_EQ(read(in("a.svg")), svg);
      const std::string png = read(in("a.png"));
      ASSERT_EQ(png.substr(1, 3), "PNG");
      EXPECT_EQ(big_endian(png, 16), std::ceil(size.width * scale)) << name << ", scale " << scale;
      EXPECT_EQ(big_endian(png, 20), std::ceil(size.height * scale)) << name << ", scale " << scale;
    }
    const std::string pdf = read(in("a.pdf"));
    EXPECT_TRUE(pdf.starts_with("%PDF-")) << name;
    std::smatch box;
    ASSERT_TRUE(std::regex_search(pdf, box, std::regex("MediaBox \\[ 0 0 ([0-9.]+) ([0-9.]+)"))) << name;
    EXPECT_NEAR(std::stod(box[1]), size.width * 0.75, 0.01) << name;  // 72 points, 96 units
    EXPECT_NEAR(std::stod(box[2]), size.height * 0.75, 0.01) << name;
  }
}

TEST_F(Pictures, TooLargeForPngAreRefused) {
  const std::string svg = R"(<svg xmlns="http://www.w3.org/2000/svg" width="4000" height="10"/>)";
  EXPECT_THROW(write_picture(svg, {.png = in("b.png"), .scale = 20}), UsageError);
  EXPECT_FALSE(std::filesystem::exists(in("b.png")));
}

TEST_F(Pictures, NeedAFile) {
  EXPECT_THROW(check_picture_files({}), UsageError);
  EXPECT_NO_THROW(check_picture_files({.svg = in("c.svg")}));
}

// A ring with chords of so many edges, in DOT.
std::string dot_of(std::size_t edges) {
  std::string out = "digraph ring {\n";
  for (std::size_t i = 0; i < edges; ++i)
    out += std::to_string(i % 90) + " -> " + std::to_string(i * i % 90) + " [label=\"a -> b\"];\n";
  return out + "}\n";
}

TEST(Layout, RefusesWhatIsTooLargeBeforeItBegins) {
  EXPECT_NO_THROW(render::lay_out(dot_of(20)));
  try {
    (void)render::lay_out(dot_of(render::most_drawn_edges + 1));
    FAIL() << "a graph of too many edges was laid out";
  } catch (const GaveUp& refused) {
    EXPECT_EQ(std::string(refused.what()),
              "not drawn: more than 250 edges; --format dot gives the graph as text, for other tools");
  }
  std::string left_out;
  EXPECT_FALSE(render::lay_out_or_leave_out(dot_of(30), {.edges = 29}, left_out));
  EXPECT_NE(left_out.find("more than 29 edges"), std::string::npos) << left_out;
}

TEST(Layout, EndsWithItsSecondsAndWhenItIsStopped) {
  const std::string large = dot_of(4'000);
  EXPECT_THROW((void)render::lay_out(large, {.edges = SIZE_MAX, .seconds = 0.2}), GaveUp);
  std::stop_source stopped;
  stopped.request_stop();
  std::string left_out;
  EXPECT_THROW((void)render::lay_out_or_leave_out(large, {.edges = SIZE_MAX, .stop = stopped.get_token()}, left_out),
               GaveUp);
}

}  // namespace
}  // namespace waymark::tools
