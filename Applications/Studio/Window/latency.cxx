#include "latency.h"

#include "files.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <chrono>
#include <ctime>

namespace oversketch_studio
{

Latency& Latency::of()
{
  static Latency one;
  return one;
}

Latency::Times Latency::now()
{
  using Milliseconds = std::chrono::duration<double, std::milli>;
  const Milliseconds wall = std::chrono::steady_clock::now().time_since_epoch();
  return { wall.count(), 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC };
}

void Latency::begin(const char* what, const std::optional<Times>& since)
{
  if (this->Path && since)
  {
    this->Waiting[what].push_back(*since);
  }
}

void Latency::hand()
{
  if (this->Path)
  {
    this->Hand = now();
  }
}

void Latency::moved(const std::string& what)
{
  this->begin(what.c_str(), this->Hand);
  if (this->Path && this->Hand)
  {
    this->Waited[what + " points"].push_back(now() - *this->Hand);
  }
}

void Latency::framePainted()
{
  if (!this->Path || !this->Frame)
  {
    return;
  }
  const Times end = now();
  bool plain = true;
  const auto answer = [&](const char* what)
  {
    for (const Times& start : this->Waiting[what])
    {
      this->Waited[what].push_back(end - start);
      plain = false;
    }
    this->Waiting[what].clear();
  };
  answer("sample");
  answer("ring");
  for (const char* dragged : { "drag", "layer" })
  {
    if (!this->Waiting[dragged].empty())
    {
      this->Waited[std::string(dragged) + " frame"].push_back(end - *this->Frame);
    }
    answer(dragged);
  }
  if (this->MeshComes)
  {
    answer("stroke");
    answer("radius");
    answer("height");
    this->MeshComes = false;
  }
  if (plain)
  {
    this->Waited["redraw"].push_back(end - *this->Frame);
  }
  this->Frame.reset();
}

void Latency::write() const
{
  if (!this->Path)
  {
    return;
  }
  QJsonObject all;
  for (const auto& [what, waited] : this->Waited)
  {
    QJsonArray list;
    for (const Times& times : waited)
    {
      list.append(QJsonArray{ times.wall, times.processors });
    }
    all[QString::fromStdString(what)] = list;
  }
  if (this->RegionVertices > 0)
  {
    all["region"] = static_cast<double>(this->RegionVertices);
  }
  oversketch_files::writeText(*this->Path, QJsonDocument(all).toJson(QJsonDocument::Compact).toStdString());
}

} // namespace oversketch_studio
