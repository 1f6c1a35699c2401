#include "Shading/layer_list.h"

#include "Mesh/context.h"

#include <algorithm>
#include <charconv>

namespace oversketch
{
namespace
{

std::vector<std::string> wordsOf(const std::string& text)
{
  std::vector<std::string> words;
  for (std::size_t at = 0; (at = text.find_first_not_of(" \t\n", at)) != std::string::npos;)
  {
    const std::size_t end = std::min(text.find_first_of(" \t\n", at), text.size());
    words.push_back(text.substr(at, end - at));
    at = end;
  }
  return words;
}

// Whether a whole word is a number.
template <typename Number>
bool read(const std::string& word, Number& number)
{
  const std::from_chars_result result = std::from_chars(word.data(), word.data() + word.size(), number);
  return result.ec == std::errc() && result.ptr == word.data() + word.size();
}

} // namespace

LayerList layerList(const std::string& text)
{
  LayerList list;
  for (std::size_t at = 0; at <= text.size();)
  {
    const std::size_t end = std::min(text.find(';', at), text.size());
    const std::string item = text.substr(at, end - at);
    at = end + 1;
    const std::vector<std::string> words = wordsOf(item);
    if (words.empty())
    {
      continue;
    }
    LayerHandle handle;
    AreaLayers area;
    if (words.size() == 3 && words[0] == "handle" && read(words[1], handle.rest) &&
        read(words[2], handle.place))
    {
      (list.areas.empty() ? list.handles : list.areas.back().handles).push_back(handle);
    }
    else if ((words.size() == 2 || words.size() == 3) && words[0] == "area" && read(words[1], area.area) &&
             (words.size() == 2 || (read(words[2], area.levels) && area.levels > 0)))
    {
      if (std::any_of(list.areas.begin(),
            list.areas.end(),
            [&](const AreaLayers& other) { return other.area == area.area; }))
      {
        throw Error(Failure::BadStroke, "{layers} names area %1 twice; put its handles together.", area.area);
      }
      list.areas.push_back(area);
    }
    else
    {
      throw Error(Failure::BadStroke,
        "{layers} says \"%1\"; give \"handle FROM TO\" or \"area NUMBER LEVELS\", with \";\" between them.",
        item);
    }
  }
  return list;
}

} // namespace oversketch
