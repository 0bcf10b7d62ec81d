#include "base/files.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <sstream>
#include <thread>

#include "base/error.h"

namespace amble {
namespace {

namespace fs = std::filesystem;

constexpr FileKind kSmall = {"a small file", 1000};

class Files : public testing::Test {
 protected:
  void SetUp() override {
    const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
    folder_ = fs::path(testing::TempDir()) / ("amble_files_" + name);
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path write(const std::string& bytes) const {
    std::ofstream(folder_ / "file", std::ios::binary) << bytes;
    return folder_ / "file";
  }
  static std::string errorOf(const fs::path& file) {
    try {
      readWholeFile(file, kSmall);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }

  fs::path folder_;
};

TEST_F(Files, WhatIsNotThereOrAFolderIsAnInputError) {
  EXPECT_EQ(errorOf(folder_ / "none"), (folder_ / "none").string() +
                                           ": cannot be opened: No such file or directory; "
                                           "expected a small file");
  EXPECT_EQ(errorOf(folder_), folder_.string() + ": is a folder; expected a small file");
}

TEST_F(Files, WhatIsLargerThanItsKindIsRefusedAndWhatIsAsLargeIsRead) {
  EXPECT_EQ(readWholeFile(write(std::string(1000, 'x')), kSmall).size(), 1000u);
  EXPECT_EQ(errorOf(write(std::string(1001, 'x'))),
            (folder_ / "file").string() +
                ": is larger than 1000 bytes; expected a small file of at most that");
}

TEST_F(Files, WhatNeverEndsIsRefused) {
  if (!fs::exists("/dev/zero")) GTEST_SKIP() << "no /dev/zero here";
  EXPECT_EQ(errorOf("/dev/zero"),
            "/dev/zero: is larger than 1000 bytes; expected a small file of at most that");
}

TEST_F(Files, APipeIsReadWheneverItsWriterCloses) {
  const fs::path pipe = folder_ / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const auto read = [&](const std::string& bytes) {
    std::thread writer([&] { std::ofstream(pipe, std::ios::binary) << bytes; });
    const std::string got = readWholeFile(pipe, kSmall);
    writer.join();
    return got;
  };
  EXPECT_EQ(read("x"), "x");
  EXPECT_EQ(read(std::string(1000, 'y')), std::string(1000, 'y'));
}

TEST_F(Files, EveryByteIsKeptAsItIs) {
  std::string bytes;
  for (int i = 0; i < 600; ++i) bytes += static_cast<char>(i % 256);
  EXPECT_EQ(readWholeFile(write(bytes), kSmall), bytes);
  EXPECT_EQ(readWholeFile(write(""), kSmall), "");
  std::istringstream in(bytes);
  EXPECT_EQ(readWholeStream(in, "text", kSmall), bytes);
}

TEST_F(Files, APipeIsReadToItsEnd) {
  const fs::path pipe = folder_ / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::thread writer([&] { std::ofstream(pipe) << "through a pipe"; });
  EXPECT_EQ(readWholeFile(pipe, kSmall), "through a pipe");
  writer.join();
}

TEST(SizeText, UsesTheLargestUnitThatDividesIt) {
  EXPECT_EQ(sizeText(64u << 20), "64 MiB");
  EXPECT_EQ(sizeText(1536), "1536 bytes");
  EXPECT_EQ(sizeText(3 << 10), "3 KiB");
  EXPECT_EQ(sizeText(0), "0 bytes");
}

}  // namespace
}  // namespace amble
