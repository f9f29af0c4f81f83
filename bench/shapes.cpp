// SPDX-License-Identifier: MIT
#include "shapes.h"

#include <ctime>

namespace homolog::bench {

double thread_seconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

void Shapes::expect(const std::string& name, std::uint64_t seed) { ++entries_[{name, seed}].expected; }

void Shapes::make(const Key& key, const std::function<Mesh()>& read, Entry& entry) const try {
  auto described = std::make_shared<DescribedShape>();
  described->mesh = read();
  const double diagonal = bounding_box(described->mesh).diagonal();
  if (key.second != 0) described->turn = random_similarity(key.second, key.first, diagonal);
  described->diagonal = described->turn.scale * diagonal;
  const Mesh turned = moved(described->turn, described->mesh);
  const double start = thread_seconds();
  described->shape = describe_shape(turned, params_);
  described->cpu_seconds = thread_seconds() - start;
  entry.shape = std::move(described);
} catch (...) {
  entry.error = std::current_exception();
}

std::shared_ptr<const DescribedShape> Shapes::get(const std::string& name, std::uint64_t seed, const std::function<Mesh()>& read) {
  const Key key{name, seed};
  std::unique_lock lock(mutex_);
  Entry& entry = entries_[key];
  made_.wait(lock, [&] { return !entry.making; });
  if (!entry.shape && !entry.error) {
    entry.making = true;
    lock.unlock();
    make(key, read, entry);  // nobody else touches the entry while it is being made
    lock.lock();
    entry.making = false;
    made_.notify_all();
  }
  if (entry.error) std::rethrow_exception(entry.error);
  const auto shape = entry.shape;
  if (--entry.expected <= 0) entry.shape.reset();
  return shape;
}

}  // namespace homolog::bench
