// How long a person waits, measured inside: from a sample of the pen to its drawn pixel, from the end of a
// stroke to the deformed mesh on screen, and for a plain redraw. Written as JSON when the program ends, where
// it was asked for.
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
  void writeTo(const std::string& path) { this->path_ = path; }

  // A sample of the pen, or the end of a stroke, has come.
  void sample() { this->begin("sample"); }
  void strokeEnd() { this->begin("stroke"); }
  // The deformed mesh is what the next frame shows.
  void meshComes() { this->meshComes_ = true; }
  // A frame begins; it is painted. A frame that nothing waited for is a plain redraw.
  void frameBegins();
  void framePainted();
  bool isOn() const { return this->path_.has_value(); }

  // Writes {"sample": [ms, ...], "stroke": [...], "redraw": [...]}. Throws Failed.
  void write() const;

private:
  using Clock = std::chrono::steady_clock;
  void begin(const char* what);

  std::optional<std::string> path_;
  std::map<std::string, std::vector<Clock::time_point>> waiting_;
  std::map<std::string, std::vector<double>> times_; // ms
  std::optional<Clock::time_point> frame_;
  bool meshComes_ = false;
};

} // namespace oversketch_studio
#endif
