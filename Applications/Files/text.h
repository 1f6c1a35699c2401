// Words and numbers of a text that a file holds.
#ifndef oversketch_applications_files_text_h
#define oversketch_applications_files_text_h

#include <charconv>
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

// A word for a message, cut where it is long.
inline std::string inQuotes(std::string_view word)
{
  return "'" + std::string(word.substr(0, 24)) + (word.size() > 24 ? "…'" : "'");
}

} // namespace oversketch_files
#endif
