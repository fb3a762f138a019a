// The state of a run as bytes: named values, written and read by the same code.
//
// A class tells its state in one function, exchange(), which names what changes from step to step:
//
//   void exchange(state::Archive& archive) {
//     archive("ux", std::span(ux_));  // as many as there are
//     archive("pairs", pairs_);       // as many as there were
//   }
//
// An archive that writes takes the values down; one that reads sets them. Everything else of an object
// follows from the scene and is built as at the start of the run. Values are the bytes of this machine's
// architecture, little-endian.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace adit::state {

inline constexpr std::size_t kPartBytes = std::size_t{8} << 20;

// A state in its order: an archive fills every part but the last to kPartBytes.
using Parts = std::vector<std::string>;
std::uint64_t size_of(const Parts& parts);

// CRC-32 (ISO 3309); of bytes that follow others, from the checksum of those before.
std::uint32_t checksum(std::string_view bytes, std::uint32_t before = 0);

class Archive {
 public:
  Archive() = default;           // writes
  explicit Archive(Parts parts)  // reads
      : parts_(std::move(parts)), reads_(true), left_(size_of(parts_)) {}

  bool reads() const { return reads_; }
  // What was written; leaves nothing behind.
  Parts take() { return std::move(parts_); }
  // After everything was read: throws where there is more.
  void require_end() const;

  // Exchanges one value, values of a number that is known, values of any number. An archive that reads throws
  // protocol::UserError where it holds another name, or another number than is known. Who reads values of any
  // number, or numbers of other things, looks whether the model has them: a state may come from anyone.
  template <class T>
  requires std::is_trivially_copyable_v<T>
  void operator()(const char* name, T& value) { (*this)(name, std::span<T>(&value, 1)); }
  template <class T, std::size_t kExtent>
  void operator()(const char* name, std::span<T, kExtent> values) {
    static_assert(std::is_trivially_copyable_v<T> && !std::is_pointer_v<T>);
    begin_fixed(name, sizeof(T), values.size());
    bytes(values.data(), values.size_bytes());
  }
  template <class T>
  void operator()(const char* name, std::vector<T>& values) {
    static_assert(std::is_trivially_copyable_v<T> && !std::is_pointer_v<T>);
    values.resize(begin(name, sizeof(T), values.size()));
    bytes(values.data(), values.size() * sizeof(T));
  }
  void operator()(const char* name, bool& value);
  void operator()(const char* name, std::vector<bool>& values);  // of a number that is known
  void operator()(const char* name, std::string& text);
  // Lists of so many values each; or nothing, where the first list was empty.
  template <class T>
  void all_or_none(const char* name, std::initializer_list<std::vector<T>*> lists, std::size_t count) {
    bool there = !(*lists.begin())->empty();
    (*this)(name, there);
    for (std::vector<T>* values : lists) {
      if (reads_) values->resize(there ? count : 0);
      (*this)(name, std::span(*values));
    }
  }
  // These members of objects whose number is known: what the scene does not determine of them.
  template <class Object, class... Member>
  void members(const char* name, std::span<Object> objects, Member... member) {
    static_assert(
        (std::is_trivially_copyable_v<std::remove_reference_t<decltype(objects[0].*member)>> && ...));
    begin_fixed(name, (sizeof(objects[0].*member) + ...), objects.size());
    for (Object& object : objects) (bytes(&(object.*member), sizeof(object.*member)), ...);
  }
  // An object that has exchange(); one that was not there when the state was written is none, one that was is
  // made.
  template <class T, class Make>
  void operator()(const char* name, std::optional<T>& object, Make&& make) {
    bool there = object.has_value();
    (*this)(name, there);
    if (!there) return object.reset();
    if (!object) object.emplace(make());
    object->exchange(*this);
  }

 private:
  // Exchange the name and the number of values, which is returned: never more than the bytes that follow.
  std::size_t begin(const char* name, std::size_t value_bytes, std::size_t count);
  void begin_fixed(const char* name, std::size_t value_bytes, std::size_t count);
  void bytes(void* data, std::size_t size);
  void write(const void* data, std::size_t size);
  void read(void* data, std::size_t size);

  Parts parts_;
  bool reads_ = false;
  // Where it reads, and how many bytes follow.
  std::size_t part_ = 0, at_ = 0;
  std::uint64_t left_ = 0;
};

// Throw protocol::UserError where a list that was read names what is not there, or cannot be the model's.
void require_of_model(bool holds, const char* name);
void require_below(std::span<const std::uint32_t> numbers, std::size_t count, const char* name);

}  // namespace adit::state
