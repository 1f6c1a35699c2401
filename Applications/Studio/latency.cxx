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

void Latency::begin(const char* what)
{
  if (this->Path)
  {
    this->Waiting[what].push_back(now());
  }
}

void Latency::frameBegins()
{
  this->Frame = now();
}

void Latency::framePainted()
{
  if (!this->Path || !this->Frame)
  {
    return;
  }
  const auto since = [end = now()](const Times& start) {
    return Times{ end.wall - start.wall, end.processors - start.processors };
  };
  bool plain = true;
  const auto answer = [&](const char* what)
  {
    for (const Times& start : this->Waiting[what])
    {
      this->Waited[what].push_back(since(start));
      plain = false;
    }
    this->Waiting[what].clear();
  };
  answer("sample");
  if (this->MeshComes)
  {
    answer("stroke");
    answer("radius");
    answer("height");
    this->MeshComes = false;
  }
  if (plain)
  {
    this->Waited["redraw"].push_back(since(*this->Frame));
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
  oversketch_files::writeText(*this->Path, QJsonDocument(all).toJson(QJsonDocument::Compact).toStdString());
}

} // namespace oversketch_studio
