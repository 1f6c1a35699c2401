// Words and numbers that a file holds, as text or as bytes.
#ifndef oversketch_applications_files_text_h
#define oversketch_applications_files_text_h

#include "files.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace oversketch_files
{

class Words
{
public:
  explicit Words(std::string_view text, std::size_t at = 0)
    : Text(text)
    , At(at)
  {
  }

  // The next word, "" at the end of the text.
  std::string_view next()
  {
    const char* const space = " \t\r\n\v\f";
    const std::size_t from = this->Text.find_first_not_of(space, this->At);
    if (from == std::string_view::npos)
    {
      this->At = this->Text.size();
      return {};
    }
    const std::size_t to = this->Text.find_first_of(space, from);
    this->At = to == std::string_view::npos ? this->Text.size() : to;
    return this->Text.substr(from, this->At - from);
  }

  // The next line without what ends it; false at the end of the text.
  bool line(std::string_view& line)
  {
    if (this->At >= this->Text.size())
    {
      return false;
    }
    const std::size_t end = this->Text.find('\n', this->At);
    line = this->Text.substr(this->At, end == std::string_view::npos ? end : end - this->At);
    this->At = end == std::string_view::npos ? this->Text.size() : end + 1;
    return true;
  }

  // The rest up to the end, without white space around it.
  std::string_view rest() const
  {
    const char* const space = " \t\r";
    const std::size_t from = std::min(this->Text.find_first_not_of(space, this->At), this->Text.size());
    return this->Text.substr(from, this->Text.find_last_not_of(space) + 1 - from);
  }

  // Where the last word or line ended.
  std::size_t at() const { return this->At; }

private:
  std::string_view Text;
  std::size_t At;
};

// The number that all of a word is; too small is zero, too large not finite.
inline std::optional<double> numberOf(std::string_view word)
{
  const char* const end = word.data() + word.size();
  const char* const from = word.data() + (!word.empty() && word[0] == '+' ? 1 : 0);
  double value = 0.0;
  const std::from_chars_result done = std::from_chars(from, end, value);
  if (done.ec == std::errc::invalid_argument || done.ptr != end)
  {
    return std::nullopt;
  }
  return done.ec == std::errc() ? value : std::strtod(std::string(from, end).c_str(), nullptr);
}

// Whether it is a word of the list, which white space parts.
inline bool isAmong(std::string_view word, std::string_view list)
{
  Words words(list);
  for (std::string_view one = words.next(); !one.empty(); one = words.next())
  {
    if (one == word)
    {
      return true;
    }
  }
  return false;
}

// A word for a message, cut where it is long.
inline std::string inQuotes(std::string_view word)
{
  return "'" + std::string(word.substr(0, 24)) + (word.size() > 24 ? "…'" : "'");
}

[[noreturn]] inline void refuse(const std::string& path, const std::string& why)
{
  throw Failed(path + ": " + why);
}

// The number that a word of a line is.
inline double numberOf(std::string_view word, const std::string& path, long line)
{
  const std::optional<double> value = numberOf(word);
  if (!value)
  {
    refuse(path,
      "line " + std::to_string(line) + (word.empty() ? " ends" : " has " + inQuotes(word)) +
        " where a number should be; the file is damaged");
  }
  return *value;
}

// List of words for a message: "one, two".
template <typename List>
std::string listed(const List& words)
{
  std::string text;
  for (const std::string& word : words)
  {
    text += (text.empty() ? "" : ", ") + word;
  }
  return text;
}

inline std::string lowerCase(std::string_view word)
{
  std::string text(word);
  std::transform(text.begin(),
    text.end(),
    text.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

// An unsigned number of so many bytes; 0 beyond the end.
inline std::uint64_t wholeAt(std::string_view bytes, std::uint64_t at, std::size_t size, bool bigEndian)
{
  std::uint64_t value = 0;
  for (std::size_t k = 0; at <= bytes.size() && bytes.size() - at >= size && k < size; ++k)
  {
    value = value << 8 | static_cast<unsigned char>(bytes[at + (bigEndian ? k : size - 1 - k)]);
  }
  return value;
}

// The bytes that base64 text tells, up to its first padding or foreign character; white space is passed by.
inline std::string bytesOfBase64(std::string_view text, std::size_t most)
{
  static const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text)
  {
    const std::size_t value = std::isspace(static_cast<unsigned char>(c)) != 0 ? 64 : letters.find(c);
    if (value == std::string::npos || bytes.size() >= most)
    {
      break;
    }
    if (value == 64)
    {
      continue;
    }
    bits = bits << 6 | static_cast<std::uint32_t>(value);
    count += 6;
    if (count >= 8)
    {
      count -= 8;
      bytes += static_cast<char>(bits >> count & 0xff);
    }
  }
  return bytes;
}

// Adds the bytes of a number.
template <typename T>
void put(std::string& bytes, T value)
{
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

} // namespace oversketch_files
#endif
