// SPDX-License-Identifier: MIT
// The shapes of a run: each is read, turned and described once, and let go when no later pair needs it.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "homolog/homolog.h"
#include "similarity.h"

namespace homolog::bench {

struct DescribedShape {
  Mesh mesh;        ///< as read
  Similarity turn;  ///< what was done to it before it was described
  Shape shape;
  double diagonal = 0;  ///< of the mesh as read, times the scale of the turn
  double cpu_seconds = 0;
};

/// CPU time of this thread, in seconds.
double thread_seconds();

class Shapes {
 public:
  explicit Shapes(Params params) : params_(params) {}

  /// One more pair of the run will ask for this shape, turned by this seed; 0: not turned.
  void expect(const std::string& name, std::uint64_t seed);

  /// The shape, made by the first who asks. Rethrows for everyone what making it threw. Counts as one of the expected uses.
  std::shared_ptr<const DescribedShape> get(const std::string& name, std::uint64_t seed, const std::function<Mesh()>& read);

 private:
  struct Entry {
    int expected = 0;
    bool making = false;
    std::shared_ptr<const DescribedShape> shape;
    std::exception_ptr error;
  };
  using Key = std::pair<std::string, std::uint64_t>;

  void make(const Key& key, const std::function<Mesh()>& read, Entry& entry) const;

  Params params_;
  std::mutex mutex_;
  std::condition_variable made_;
  std::map<Key, Entry> entries_;
};

}  // namespace homolog::bench
