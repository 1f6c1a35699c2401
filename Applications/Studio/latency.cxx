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
  if (this->path_)
  {
    this->waiting_[what].push_back(Clock::now());
  }
}

void Latency::frameBegins()
{
  this->frame_ = Clock::now();
}

void Latency::framePainted()
{
  if (!this->path_ || !this->frame_)
  {
    return;
  }
  const Clock::time_point now = Clock::now();
  const auto since = [now](Clock::time_point start)
  { return std::chrono::duration<double, std::milli>(now - start).count(); };
  bool plain = true;
  const auto answer = [&](const char* what)
  {
    for (const Clock::time_point& start : this->waiting_[what])
    {
      this->times_[what].push_back(since(start));
      plain = false;
    }
    this->waiting_[what].clear();
  };
  answer("sample");
  if (this->meshComes_)
  {
    answer("stroke");
    this->meshComes_ = false;
  }
  if (plain)
  {
    this->times_["redraw"].push_back(since(*this->frame_));
  }
  this->frame_.reset();
}

void Latency::write() const
{
  if (!this->path_)
  {
    return;
  }
  QJsonObject all;
  for (const auto& [what, times] : this->times_)
  {
    QJsonArray list;
    for (const double ms : times)
    {
      list.append(ms);
    }
    all[QString::fromStdString(what)] = list;
  }
  oversketch_files::writeText(*this->path_, QJsonDocument(all).toJson(QJsonDocument::Compact).toStdString());
}

} // namespace oversketch_studio
