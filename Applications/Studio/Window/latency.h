// How long a person waits, measured inside: from a sample of the pen to its drawn pixel, from the end of a
// stroke or a notch of the wheel to the new mesh on screen, from the hand's event at an edit to the moved
// mesh on screen, and for a plain redraw; and how long processors were at work for the program meanwhile,
// which other programs change little. Written as JSON when the program ends, where it was asked for.
#ifndef oversketch_applications_studio_window_latency_h
#define oversketch_applications_studio_window_latency_h

#include <cstddef>
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

  // A sample of the pen, the end of a stroke, or a turn of the wheel that changes a line has come.
  void sample() { this->begin("sample"); }
  void strokeEnd() { this->begin("stroke"); }
  void radius() { this->begin("radius"); }
  void height() { this->begin("height"); }
  // The hand's event has come, of which all of these come: a line or a layer was dragged, and points and
  // normals are where it has taken them; a ring was closed, and greys are there.
  void hand();
  void dragged() { this->moved("drag"); }
  void layerDragged() { this->moved("layer"); }
  void ringClosed() { this->moved("ring"); }
  void regionHas(std::size_t vertices) { this->RegionVertices = vertices; }
  // The deformed mesh is what the next frame shows.
  void meshComes() { this->MeshComes = true; }
  // A frame begins; it is painted. A frame that nothing waited for is a plain redraw.
  void frameBegins() { this->Frame = now(); }
  void framePainted();
  bool isOn() const { return this->Path.has_value(); }

  // Writes {"sample": [[ms, ms of processors], ...], "stroke": [...], "radius": [...], "height": [...],
  // "redraw": [...], "ring": [...], "drag": [...], "drag points": [...], "drag frame": [...], the same of
  // "layer", "ring points": [...], "region": n}: of a drag the whole, its part until points and normals, and
  // that of drawing alone; of a ring the part until greys are there; vertices within the last one. Throws
  // Failed.
  void write() const;

private:
  struct Times // ms
  {
    double wall, processors;
    Times operator-(const Times& start) const
    {
      return { this->wall - start.wall, this->processors - start.processors };
    }
  };
  static Times now();
  void begin(const char* what) { this->begin(what, now()); }
  void begin(const char* what, const std::optional<Times>& since);
  void moved(const std::string& what);

  std::optional<std::string> Path;
  std::map<std::string, std::vector<Times>> Waiting; // since when
  std::map<std::string, std::vector<Times>> Waited;
  std::optional<Times> Frame, Hand;
  bool MeshComes = false;
  std::size_t RegionVertices = 0; // of the ring that was closed last
};

} // namespace oversketch_studio
#endif
