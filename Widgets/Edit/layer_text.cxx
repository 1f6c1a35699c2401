#include "layer_text.h"

#include <algorithm>
#include <locale>
#include <sstream>

namespace oversketch
{

std::string layerText(const LayerList& list)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  const char* apart = "";
  const auto write = [&](const std::vector<LayerHandle>& handles)
  {
    for (const LayerHandle& handle : handles)
    {
      text << apart << "handle " << handle.rest << ' ' << handle.place;
      apart = "; ";
    }
  };
  write(list.handles);
  for (const AreaLayers& area : list.areas)
  {
    text << apart << "area " << area.area;
    apart = "; ";
    if (area.levels > 0)
    {
      text << ' ' << area.levels;
    }
    write(area.handles);
  }
  return text.str();
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
