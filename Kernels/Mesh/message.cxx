#include "message.h"

#include <algorithm>
#include <cctype>

namespace oversketch
{

std::string Message::propertyIn(const std::string& named)
{
  std::string property = named.substr(0, named.find(' '));
  property[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(property[0])));
  return property;
}

std::string Message::valueIn(const std::string& named)
{
  const std::size_t space = named.find(' ');
  return space == std::string::npos ? "" : named.substr(space + 1);
}

std::string Message::asProperty(const std::string& named)
{
  const std::string value = valueIn(named);
  const bool isTurned = value == "on" || value == "off";
  const bool isSet = isTurned || std::isupper(static_cast<unsigned char>(value[0])) != 0;
  return value.empty() && named.find(' ') == std::string::npos ? propertyIn(named)
         : isSet ? (isTurned ? "turn " : "") + propertyIn(named) + ' ' + value
                 : named;
}

Message::Message(const std::string& verbatim)
{
  if (!verbatim.empty())
  {
    this->Text = "%1";
    this->Places.push_back({ verbatim, false, {} });
  }
}

Message Message::joined(const std::vector<Message>& all, const std::string& between)
{
  if (all.size() < 2)
  {
    return all.empty() ? Message() : all.front();
  }
  Message message;
  message.Text = "%1";
  message.Places.push_back({ {}, false, all, between });
  return message;
}

const Message& Message::first() const
{
  const bool isJoined = this->Text == "%1" && !this->Places.front().messages.empty();
  return isJoined ? this->Places.front().messages.front().first() : *this;
}

Message Message::unusable(const std::string& what, long long number, const Message& why)
{
  return { ("{" + what + " %1} cannot be used: %2").c_str(), number, why };
}

std::string Message::filled(const std::string& words, const Wording& wording) const
{
  std::string said;
  for (std::size_t i = 0; i < words.size(); ++i)
  {
    const int digit = words[i] == '%' && i + 1 < words.size() ? words[i + 1] - '1' : -1;
    if (digit >= 0 && digit < static_cast<int>(this->Places.size()))
    {
      const Argument& argument = this->Places[static_cast<std::size_t>(digit)];
      for (std::size_t k = 0; k < argument.messages.size(); ++k)
      {
        said += (k > 0 ? argument.between : "") + argument.messages[k].text(wording);
      }
      said += argument.isNumber && wording.number ? wording.number(argument.text) : argument.text;
      ++i;
    }
    else if (words[i] == '{')
    {
      const std::size_t end = std::min(words.find('}', i), words.size());
      const std::string named = this->filled(words.substr(i + 1, end - i - 1), {});
      said += wording.name ? wording.name(named) : asProperty(named);
      i = end;
    }
    else
    {
      said += words[i];
    }
  }
  return said;
}

std::string Message::text(const Wording& wording) const
{
  return this->filled(wording.words ? wording.words(this->Text) : this->Text, wording);
}

Message Message::renumbered(const std::function<int(int stroke)>& number) const
{
  Message other = *this;
  for (Argument& argument : other.Places)
  {
    for (Message& message : argument.messages)
    {
      message = message.renumbered(number);
    }
  }
  for (const std::string before : { "{stroke %", "{Stroke %" })
  {
    for (std::size_t at = 0; (at = this->Text.find(before, at)) != std::string::npos;)
    {
      at += before.size();
      const auto place = static_cast<std::size_t>(this->Text[at] - '1');
      if (place < this->Places.size() && this->Places[place].isNumber)
      {
        other.Places[place].text = std::to_string(number(std::stoi(this->Places[place].text)));
      }
    }
  }
  return other;
}

std::vector<std::string> Message::named() const
{
  std::vector<std::string> all;
  Wording collect;
  collect.name = [&all](const std::string& named)
  {
    all.push_back(named);
    return named;
  };
  this->text(collect);
  return all;
}

bool Message::names(const std::string& named) const
{
  const std::vector<std::string> all = this->named();
  return std::find(all.begin(), all.end(), named) != all.end();
}

} // namespace oversketch
