#include "viz/exchange/npy_archive.h"

#include <gtest/gtest.h>

#include <cstring>
#include <locale>
#include <sstream>

namespace amble {
namespace {

std::string writtenBy(const NpyArchive& archive) {
  std::ostringstream out;
  archive.write(out);
  return out.str();
}

uint32_t numberAt(const std::string& bytes, size_t at, int count) {
  uint32_t number = 0;
  std::memcpy(&number, bytes.data() + at, count);
  return number;
}

// The bytes of a file of the archive, found through its directory, at whose end no comment is.
std::string fileOf(const std::string& zip, const std::string& name) {
  const size_t end = zip.size() - 22;
  EXPECT_EQ(zip.substr(end, 4), "PK\x05\x06");
  size_t at = numberAt(zip, end + 16, 4);
  for (uint32_t left = numberAt(zip, end + 10, 2); left > 0; --left) {
    EXPECT_EQ(zip.substr(at, 4), "PK\x01\x02");
    const uint32_t length = numberAt(zip, at + 28, 2);
    const size_t local = numberAt(zip, at + 42, 4);
    if (zip.substr(at + 46, length) == name)
      return zip.substr(local + 30 + length, numberAt(zip, at + 24, 4));
    at += 46 + length;
  }
  ADD_FAILURE() << "no " << name;
  return "";
}

TEST(NpyArchive, ValuesLieBehindAHeaderThatSaysTheirTypeAndShape) {
  const std::vector<double> numbers = {1.0, -2.5, 1e300, 0.1, 5.0, 6.0};
  const std::vector<int32_t> whole = {-1, 7};
  NpyArchive archive;
  archive.add("whole", std::span(whole), {2});
  archive.add("numbers", std::span(numbers), {2, 3});
  const std::string file = fileOf(writtenBy(archive), "numbers.npy");
  EXPECT_EQ(file.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
  const size_t values = 10 + numberAt(file, 8, 2);
  EXPECT_EQ(values % 64, 0u) << "NPY 1.0: aligned";
  const std::string header = file.substr(10, values - 10);
  EXPECT_EQ(header.find("{'descr': '<f8', 'fortran_order': False, 'shape': (2, 3), }"), 0u);
  EXPECT_EQ(header.back(), '\n');
  ASSERT_EQ(file.size(), values + 6 * sizeof(double));
  EXPECT_EQ(std::memcmp(file.data() + values, numbers.data(), 6 * sizeof(double)), 0);
}

TEST(NpyArchive, TextsAreTheirCharactersWhateverTheBytes) {
  const std::vector<std::string> texts = {"\xe8\x85\xb0\xf0\x9f\x9a\xb6", "", "a\xff"};
  NpyArchive archive;
  archive.addTexts("texts", std::span(texts), {3});
  const std::string file = fileOf(writtenBy(archive), "texts.npy");
  EXPECT_NE(file.find("'<U2'"), std::string::npos) << file;
  const std::vector<uint32_t> expected = {0x8170, 0x1f6b6, 0, 0, 'a', 0xfffd};
  const size_t values = 10 + numberAt(file, 8, 2);
  ASSERT_EQ(file.size(), values + 24);
  EXPECT_EQ(std::memcmp(file.data() + values, expected.data(), 24), 0);
}

TEST(NpyArchive, EveryFileIsOfTheSameDay) {
  const std::vector<int32_t> whole = {1};
  NpyArchive archive;
  archive.add("a", std::span(whole), {});
  const std::string zip = writtenBy(archive);
  EXPECT_EQ(numberAt(zip, 10, 4), 0x00210000u) << "1980-01-01 00:00, the first day of MS-DOS";
}

TEST(NpyArchive, ALocaleWritesTheSameBytes) {
  struct Dots : std::numpunct<char> {
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\1"; }
  };
  const std::vector<double> numbers(1234, 0.5);
  NpyArchive archive;
  archive.add("numbers", std::span(numbers), {1234});
  std::ostringstream out;
  out.imbue(std::locale(out.getloc(), new Dots));
  archive.write(out);
  EXPECT_EQ(out.str(), writtenBy(archive));
}

}  // namespace
}  // namespace amble
