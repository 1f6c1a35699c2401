#include "Shading/layer_list.h"

#include "Mesh/context.h"

#include <algorithm>
#include <charconv>
#include <iterator>

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

// The shortest text that is read as the number.
std::string written(double number)
{
  char digits[32];
  return { digits, std::to_chars(digits, std::end(digits), number, std::chars_format::general).ptr };
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

std::string layerText(const LayerList& list)
{
  std::string text;
  const auto add = [&](const std::string& word) { text += (text.empty() ? "" : "; ") + word; };
  const auto addHandles = [&](const std::vector<LayerHandle>& handles)
  {
    for (const LayerHandle& handle : handles)
    {
      add("handle " + written(handle.rest) + ' ' + written(handle.place));
    }
  };
  addHandles(list.handles);
  for (const AreaLayers& area : list.areas)
  {
    add("area " + std::to_string(area.area) + (area.levels > 0 ? ' ' + std::to_string(area.levels) : ""));
    addHandles(area.handles);
  }
  return text;
}

std::string layersOfAreas(const std::string& layers, int areas)
{
  LayerList list = layerList(layers);
  list.areas.erase(
    std::remove_if(
      list.areas.begin(), list.areas.end(), [areas](const AreaLayers& area) { return area.area >= areas; }),
    list.areas.end());
  return layerText(list);
}

std::vector<LayerHandle>& handlesIn(LayerList& list, int area)
{
  if (area < 0)
  {
    return list.handles;
  }
  const auto known = std::find_if(
    list.areas.begin(), list.areas.end(), [&](const AreaLayers& other) { return other.area == area; });
  return known != list.areas.end() ? known->handles
                                   : list.areas.emplace_back(AreaLayers{ area, 0, {} }).handles;
}

Layers layersOf(const LayerList& list, int area, int levels)
{
  for (const AreaLayers& own : list.areas)
  {
    if (own.area == area)
    {
      return Layers(own.levels > 0 ? own.levels : levels, own.handles.empty() ? list.handles : own.handles);
    }
  }
  return Layers(levels, list.handles);
}

} // namespace oversketch
