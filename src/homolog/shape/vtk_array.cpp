// SPDX-License-Identifier: MIT
#include "homolog/shape/vtk_array.h"

#include <fmt/format.h>

#include <algorithm>

#include "homolog/base/errors.h"
#include "homolog/shape/base64.h"
#include "homolog/shape/inflate.h"
#include "homolog/shape/text.h"

namespace homolog {
namespace {

[[noreturn]] void fail(const VtkStorage& storage, const char* what) {
  throw FileError(fmt::format("{}: {}; the file is truncated or damaged", storage.file, what));
}

/// Bytes one after the other, wherever they stand.
class Bytes {
 public:
  Bytes(const VtkArray& array, const VtkStorage& storage)
      : storage_(storage),
        rest_(array.appended_at ? storage.appended : array.text),
        base64_(array.appended_at ? storage.appended_base64 : array.binary) {
    const std::size_t at = array.appended_at.value_or(0);
    if (at > rest_.size()) fail(storage, "an array begins behind the end of the file");
    rest_.remove_prefix(at);
  }

  std::string take(std::size_t count) {
    if (base64_ && count <= decoded_.size() + rest_.size() && !decode_base64(rest_, count, decoded_))
      fail(storage_, "an array holds what is not base64");
    if (count > (base64_ ? decoded_ : rest_).size()) fail(storage_, "an array is longer than the file");
    std::string bytes((base64_ ? std::string_view(decoded_) : rest_).substr(0, count));
    if (base64_) {
      decoded_.erase(0, count);
    } else {
      rest_.remove_prefix(count);
    }
    return bytes;
  }

  /// A number of bytes or of pieces.
  std::size_t take_size() {
    const double size = stored_number(take(bytes_of(storage_.sizes)).data(), storage_.sizes, storage_.order);
    if (!(size >= 0 && size < 1e15)) fail(storage_, "an array is longer than the file");  // headers may say that sizes have signs
    return static_cast<std::size_t>(size);
  }

 private:
  const VtkStorage& storage_;
  std::string_view rest_;
  bool base64_;
  std::string decoded_;
};

void refuse_unknown_compressor(const VtkStorage& storage) {
  if (storage.compressor.empty() || storage.compressor == "vtkZLibDataCompressor") return;
  throw FileError(fmt::format("{}: it is compressed by {}, which is not read; save it with zlib or uncompressed", storage.file,
                              shown(storage.compressor)));
}

/// The number of pieces, the length of all, the length of the last (0: it is a whole one), the compressed lengths, then the pieces.
std::string take_compressed(Bytes& bytes, std::size_t wanted, const VtkStorage& storage) {
  const std::size_t pieces = bytes.take_size(), whole = bytes.take_size(), last = bytes.take_size();
  if (pieces > wanted) fail(storage, "an array has another length than it must have");
  std::vector<std::size_t> compressed;
  for (std::size_t i = 0; i < pieces; ++i) compressed.push_back(bytes.take_size());
  std::string content;
  for (std::size_t i = 0; i < pieces; ++i) {
    const std::size_t length = i + 1 == pieces && last > 0 ? last : whole;
    if (length > wanted - content.size()) fail(storage, "an array has another length than it must have");
    const std::string piece = inflate(bytes.take(compressed[i]), length, storage.file);
    if (piece.size() != length) fail(storage, "a compressed piece is too short");
    content += piece;
  }
  return content;
}

/// Behind the numbers there may be more, such as what VTK knows of an array (InformationKey).
std::vector<double> read_text(std::string_view text, std::size_t count, const VtkStorage& storage) {
  if (count > text.size() / 2 + 1) fail(storage, "an array is longer than the file");
  const std::string_view plain = text.substr(0, text.find_first_of("<&"));
  Text rest{storage.file, plain};
  std::string_view line;
  std::vector<double> numbers;
  while (numbers.size() < count) {
    while (line.find_first_not_of(" \t\r") == std::string_view::npos) {
      if (next_line(rest, line)) continue;
      if (plain.size() == text.size()) fail(storage, "an array has fewer numbers than it must have");
      throw FileError(
          fmt::format("{}: comments, CDATA or character references stand among its numbers, which are not read; save it with "
                      "binary data",
                      storage.file));
    }
    numbers.push_back(take_number(rest, line, "what stands in an array"));
  }
  return numbers;
}

}  // namespace

std::string first_text_of(const VtkArray& array, const VtkStorage& storage) {
  constexpr std::size_t longest = 1024;
  std::string text;
  if (array.binary || array.appended_at) {
    refuse_unknown_compressor(storage);
    Bytes bytes(array, storage);
    text = storage.compressor.empty() ? bytes.take(bytes.take_size()) : take_compressed(bytes, longest, storage);
  } else {  // its characters as numbers
    Text place{storage.file, array.text};
    for (std::string_view line; next_line(place, line);) {
      while (!rest_of(line).empty()) text += static_cast<char>(take_integer(place, line, "a character of a text"));
    }
  }
  return text.substr(0, text.find('\0'));
}

std::vector<double> numbers_of(const VtkArray& array, std::size_t count, const VtkStorage& storage) {
  if (!array.binary && !array.appended_at) return read_text(array.text, count, storage);
  const std::size_t size = bytes_of(array.type);
  if (count > (std::size_t{1} << 40)) fail(storage, "an array is longer than the file");
  refuse_unknown_compressor(storage);
  Bytes bytes(array, storage);
  std::string content;
  if (!storage.compressor.empty()) {
    content = take_compressed(bytes, count * size, storage);
  } else if (bytes.take_size() == count * size) {
    content = bytes.take(count * size);
  }
  if (content.size() != count * size) fail(storage, "an array has another length than it must have");
  std::vector<double> numbers(count);
  for (std::size_t i = 0; i < count; ++i) numbers[i] = stored_number(content.data() + i * size, array.type, storage.order);
  return numbers;
}

}  // namespace homolog
