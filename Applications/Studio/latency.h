// How long a person waits, measured inside: from a sample of the pen to its drawn pixel, from the end of a
// stroke or a notch of the wheel to the new mesh on screen, and for a plain redraw. Written as JSON when the
// program ends, where it was asked for.
#ifndef oversketch_studio_latency_h
#define oversketch_studio_latency_h

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace oversketch_studio
{

class Latency
{
public:
  // One for the program.
  static Latency& of();

  // From here on times are kept.
  void writeTo(const std::string& path) { this->Path = path; }

  // A sample of the pen, the end of a stroke, or a turn of the wheel that a tool uses, has come.
  void sample() { this->begin("sample"); }
  void strokeEnd() { this->begin("stroke"); }
  void notch() { this->begin("notch"); }
  // The deformed mesh is what the next frame shows.
  void meshComes() { this->MeshComes = true; }
  // A frame begins; it is painted. A frame that nothing waited for is a plain redraw.
  void frameBegins();
  void framePainted();
  bool isOn() const { return this->Path.has_value(); }

  // Writes {"sample": [ms, ...], "stroke": [...], "notch": [...], "redraw": [...]}. Throws Failed.
  void write() const;

private:
  using Clock = std::chrono::steady_clock;
  void begin(const char* what);

  std::optional<std::string> Path;
  std::map<std::string, std::vector<Clock::time_point>> Waiting;
  std::map<std::string, std::vector<double>> Times; // ms
  std::optional<Clock::time_point> Frame;
  bool MeshComes = false;
};

} // namespace oversketch_studio
#endif
