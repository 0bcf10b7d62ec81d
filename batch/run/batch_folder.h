/// Where a batch writes: a folder a walk, by what it is of.
///
///     DIR/walks/3f/3f2a9c0b1d4e5f60/   row.json, and what was asked for
///     DIR/index.csv, DIR/index.jsonl, DIR/CREDITS.md    of all walks, by the job's order
///
/// A walk's folder gets its name when all is in it, so whatever has a name is whole.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace amble {

class BatchFolder {
 public:
  explicit BatchFolder(std::filesystem::path root) : root_(std::move(root)) {}

  const std::filesystem::path& root() const { return root_; }
  std::filesystem::path walks() const { return root_ / "walks"; }
  /// Relative to the root.
  static std::filesystem::path nameOf(const std::string& key) {
    return std::filesystem::path("walks") / key.substr(0, 2) / key;
  }
  std::filesystem::path folderOf(const std::string& key) const { return root_ / nameOf(key); }
  bool has(const std::string& key) const;
  void remove(const std::string& key) const;  ///< where it is there
  /// Fills a folder beside by `write`, then gives it the walk's name. Where another has made it
  /// meanwhile, that one stays: it has the same bytes. @throws InputError
  void make(const std::string& key,
            const std::function<void(const std::filesystem::path&)>& write) const;
  /// Takes away every walk that `keep` does not want, and what killed runs left beside.
  /// @return how many walks went
  int sweep(const std::function<bool(const std::string& key)>& keep) const;

 private:
  std::filesystem::path root_;
};

}  // namespace amble
