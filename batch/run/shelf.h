/// What several tasks use and one of them makes: each thing is made when it is first asked for, and
/// gone when the last that uses it is done.
#pragma once

#include <deque>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace amble {

template <typename T>
class Shelf {
 public:
  /// @param uses  how often each thing is going to be asked for, by its index
  explicit Shelf(std::span<const int> uses) {
    for (const int count : uses) places_.emplace_back().uses = count;
  }

  /// The thing. Others that ask meanwhile wait for it. @param make  returns a shared_ptr<const T>
  template <typename Make>
  std::shared_ptr<const T> get(int index, const Make& make) {
    Place& place = places_[static_cast<size_t>(index)];
    const std::lock_guard lock(place.mutex);
    if (!place.thing) place.thing = make();
    return place.thing;
  }
  /// One of its uses is over, whether it was asked for or not. @return whether it was the last
  bool used(int index) {
    Place& place = places_[static_cast<size_t>(index)];
    const std::lock_guard lock(place.mutex);
    if (--place.uses > 0) return false;
    place.thing.reset();
    return true;
  }

 private:
  struct Place {
    std::mutex mutex;
    std::shared_ptr<const T> thing;
    int uses = 0;
  };
  std::deque<Place> places_;
};

}  // namespace amble
