// A message as data: a text with places, and what stands in them.
#ifndef oversketch_kernels_mesh_message_h
#define oversketch_kernels_mesh_message_h

#include <functional>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

namespace oversketch
{

// The text is English and is what a message is known by: a window finds its own words by it, a translator
// a translation. Arguments stand where it has %1, %2, …, %9. Braces hold what each host calls by a name of
// its own:
//
//   {MaximumGap}    a property             "lower {SeedMargin}" -> "lower SeedMargin", "lower --seed-margin"
//   {AllowTorn on}  one to be turned       "{AllowTorn on}"     -> "turn AllowTorn on", "give --allow-torn"
//   {Rule Off}      one set to a choice    "{Rule Off}"         -> "Rule Off", "--rule off"
//   {stroke %1}     a stroke by its number, or {Stroke %1} where a sentence begins
//
// A kernel's option begins with a small letter there, as in its code; properties have it large.
class Message
{
public:
  // A number, a text, or one or several messages, which are told one after the other.
  struct Argument
  {
    std::string text;
    bool isNumber = false;
    std::vector<Message> messages;
    std::string between = "; ";
  };

  // How a host tells it; a function that is absent changes nothing.
  struct Wording
  {
    std::function<std::string(const std::string& text)> words;    // of a whole text, with its places
    std::function<std::string(const std::string& number)> number; // of one as a stream writes it
    std::function<std::string(const std::string& named)> name;    // of what stands in braces
  };

  Message() = default;
  template <typename... Arguments>
  Message(const char* text, const Arguments&... arguments)
    : Text(text)
    , Places{ argumentOf(arguments)... }
  {
  }
  // Said as it is: nothing in it is a place or a name.
  Message(const std::string& verbatim);

  // Several one after the other, as sentences are; the first of them, of one message that.
  static Message joined(const std::vector<Message>& all, const std::string& between = " ");
  const Message& first() const;
  // "Stroke 3 cannot be used: why", of a thing by its number.
  static Message unusable(const std::string& what, long long number, const Message& why);

  bool empty() const { return this->Text.empty(); }
  // The text that it is known by, and what stands in its places.
  const std::string& id() const { return this->Text; }
  const std::vector<Argument>& arguments() const { return this->Places; }
  // As filters tell it.
  std::string text() const { return this->text({}); }
  std::string text(const Wording& wording) const;
  // Whether it is about something in braces, such as "AllowTorn on", or one of its messages is.
  bool names(const std::string& named) const;
  // The same about other strokes: each number of a stroke, in its messages too, becomes what `number` gives.
  Message renumbered(const std::function<int(int stroke)>& number) const;
  // All that it or its messages have in braces.
  std::vector<std::string> named() const;

  // Parts of what stands in braces: the property, with a large letter, and what it is to be set to, "on",
  // "off", a choice or none; and as a filter calls it.
  static std::string propertyIn(const std::string& named);
  static std::string valueIn(const std::string& named);
  static std::string asProperty(const std::string& named);

  bool operator==(const Message& other) const { return this->text() == other.text(); }
  bool operator!=(const Message& other) const { return !(*this == other); }
  bool operator<(const Message& other) const { return this->text() < other.text(); }
  friend std::ostream& operator<<(std::ostream& out, const Message& message) { return out << message.text(); }

private:
  template <typename T>
  static Argument argumentOf(const T& value)
  {
    if constexpr (std::is_same_v<T, Message>)
    {
      return { {}, false, { value } };
    }
    else if constexpr (std::is_same_v<T, std::vector<Message>>)
    {
      return { {}, false, value };
    }
    else
    {
      std::ostringstream text;
      text << value;
      return { text.str(), std::is_arithmetic_v<T> && !std::is_same_v<T, char>, {} };
    }
  }
  std::string filled(const std::string& words, const Wording& wording) const;

  std::string Text;
  std::vector<Argument> Places;
};

} // namespace oversketch
#endif
