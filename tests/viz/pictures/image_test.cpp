#include "viz/pictures/image.h"

#include <gtest/gtest.h>
#include <png.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "base/error.h"
#include "viz/pictures/tiny_text.h"

namespace amble {
namespace {

std::string pngOf(const Image& image) {
  std::ostringstream out;
  writePng(out, image);
  return out.str();
}

Image gradient(int width, int height) {
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      image.pixel(x, y)[0] = static_cast<uint8_t>(x * 7);
      image.pixel(x, y)[1] = static_cast<uint8_t>(y * 5);
      image.pixel(x, y)[2] = static_cast<uint8_t>(x ^ y);
    }
  return image;
}

TEST(Image, IsNotWrittenIntoAFolderThatIsNotThere) {
  const auto file = std::filesystem::path("no-such-folder") / "a.png";
  EXPECT_THROW(writePng(file, gradient(4, 4)), InputError);
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST(Image, ReadsBackAsWritten) {
  const Image image = gradient(37, 23);
  const std::string bytes = pngOf(image);
  png_image read;
  std::memset(&read, 0, sizeof read);
  read.version = PNG_IMAGE_VERSION;
  ASSERT_TRUE(png_image_begin_read_from_memory(&read, bytes.data(), bytes.size()));
  ASSERT_EQ(static_cast<int>(read.width), 37);
  ASSERT_EQ(static_cast<int>(read.height), 23);
  read.format = PNG_FORMAT_RGB;
  std::vector<uint8_t> pixels(PNG_IMAGE_SIZE(read));
  ASSERT_TRUE(png_image_finish_read(&read, nullptr, pixels.data(), 0, nullptr));
  EXPECT_EQ(pixels, image.rgb);
}

TEST(Image, GivesTheSameBytesTwice) { EXPECT_EQ(pngOf(gradient(64, 48)), pngOf(gradient(64, 48))); }

TEST(TinyText, StaysInsideThePictureAndItsWidth) {
  Image image(20, 10);
  drawText(image, 1, 1, "17", 1, rgb(255, 255, 255));
  fillRect(image, -5, -5, 3, 3, rgb(255, 0, 0));       // wholly outside
  drawText(image, 15, 6, "88888", 3, rgb(0, 255, 0));  // mostly outside
  int lit = 0;
  for (int y = 1; y < 8; ++y)
    for (int x = 1; x < 1 + textWidth("17", 1); ++x) lit += image.pixel(x, y)[0] == 255;
  EXPECT_GT(lit, 10);
  EXPECT_EQ(image.pixel(0, 0)[0], 0);
}

/// The names of a PNG's chunks, in order; their lengths must fill the file.
std::vector<std::string> chunksOf(const std::string& bytes) {
  std::vector<std::string> names;
  size_t at = 8;  // behind the signature
  while (at + 8 <= bytes.size()) {
    size_t length = 0;
    for (size_t i = 0; i < 4; ++i)
      length = 256 * length + static_cast<unsigned char>(bytes[at + i]);
    names.push_back(bytes.substr(at + 4, 4));
    at += length + 12;
  }
  EXPECT_EQ(at, bytes.size());
  return names;
}

// A time stamp or a program's name would make two pictures of the same walk differ.
TEST(Image, HoldsThePictureAndNothingElse) {
  for (const auto& [width, height] : {std::pair{1, 1}, std::pair{300, 200}, std::pair{5, 900}}) {
    const std::string bytes = pngOf(gradient(width, height));
    EXPECT_EQ(bytes.substr(0, 8), "\x89PNG\r\n\x1a\n");
    const auto chunks = chunksOf(bytes);
    ASSERT_GE(chunks.size(), 3u);
    EXPECT_EQ(chunks.front(), "IHDR");
    EXPECT_EQ(chunks.back(), "IEND");
    for (size_t i = 1; i + 1 < chunks.size(); ++i) EXPECT_EQ(chunks[i], "IDAT");
  }
}

TEST(Image, AFileHoldsTheSameBytesAsAStream) {
  const auto file = std::filesystem::path(testing::TempDir()) / "amble-image-test.png";
  writePng(file, gradient(31, 17));
  std::ifstream in(file, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(in)), {});
  EXPECT_EQ(bytes, pngOf(gradient(31, 17)));
  std::filesystem::remove(file);
}

TEST(Image, PixelsAreRowsFromTheTop) {
  Image image(4, 3);
  image.pixel(3, 2)[1] = 9;
  EXPECT_EQ(image.rgb.size(), 36u);
  EXPECT_EQ(image.rgb[(2 * 4 + 3) * 3 + 1], 9);
  const Image& same = image;
  EXPECT_EQ(same.pixel(3, 2), image.pixel(3, 2));
}

}  // namespace
}  // namespace amble
