#include "latency.h"

#include "files.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace oversketch_studio
{

Latency& Latency::of()
{
  static Latency one;
  return one;
}

void Latency::begin(const char* what)
{
  if (this->Path)
  {
    this->Waiting[what].push_back(Clock::now());
  }
}

void Latency::frameBegins()
{
  this->Frame = Clock::now();
}

void Latency::framePainted()
{
  if (!this->Path || !this->Frame)
  {
    return;
  }
  const Clock::time_point now = Clock::now();
  const auto since = [now](Clock::time_point start)
  { return std::chrono::duration<double, std::milli>(now - start).count(); };
  bool plain = true;
  const auto answer = [&](const char* what)
  {
    for (const Clock::time_point& start : this->Waiting[what])
    {
      this->Times[what].push_back(since(start));
      plain = false;
    }
    this->Waiting[what].clear();
  };
  answer("sample");
  if (this->MeshComes)
  {
    answer("stroke");
    answer("notch");
    this->MeshComes = false;
  }
  if (plain)
  {
    this->Times["redraw"].push_back(since(*this->Frame));
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
  for (const auto& [what, times] : this->Times)
  {
    QJsonArray list;
    for (const double ms : times)
    {
      list.append(ms);
    }
    all[QString::fromStdString(what)] = list;
  }
  oversketch_files::writeText(*this->Path, QJsonDocument(all).toJson(QJsonDocument::Compact).toStdString());
}

} // namespace oversketch_studio
