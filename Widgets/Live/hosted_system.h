// A system that a widget hosts: the mesh that it runs on, what it makes of it and what it says.
#ifndef oversketch_widgets_live_hosted_system_h
#define oversketch_widgets_live_hosted_system_h

#include "Mesh/message.h"
#include "OversketchWidgetsLiveModule.h" // For export macro
#include "vtkOversketchSystem.h"

#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <functional>
#include <string>
#include <utility>

class vtkAlgorithm;
class vtkAlgorithmOutput;
class vtkTrivialProducer;

namespace oversketch
{

class OVERSKETCHWIDGETSLIVE_EXPORT HostedSystem
{
public:
  HostedSystem();
  ~HostedSystem();

  // The system that runs; one has to be set before anything else is asked. Its inputs are the widget's.
  vtkOversketchSystem* system() const { return this->System; }
  void setSystem(vtkOversketchSystem* system) { this->System = system; }
  void setSource(vtkAlgorithmOutput* source);
  void setSource(vtkPolyData* mesh);
  vtkAlgorithmOutput* outputPort();
  vtkPolyData* output() { return this->Output; }
  // The mesh that the system runs on.
  vtkPolyData* base() { return this->Base; }

  // Brings the source up to date. Another mesh of it is the base, and so is the output; returns whether.
  bool follow();
  // Runs the system: the output is what it makes, the base where it makes none. Returns why it did not, else
  // the last warning; each is told as it comes.
  Message run(const std::function<void(const Message&)>& warned = nullptr);
  bool acted() const { return this->Acted; }
  // Whether the system has been changed since it ran, or since somebody looked.
  bool isNewer();
  void look();
  // The output becomes the base; or it is the base again.
  void commit();
  void drop();

  // Takes what is to be said. Returns whether it is news: not empty, and in other words than before.
  bool say(const Message& message);
  const Message& said() const { return this->Said; }
  const char* text() const { return this->Text.c_str(); }

  // The widget is brought up to date when the renderer is about to draw the mesh.
  template <typename Widget>
  void watch(vtkRenderer* renderer, Widget* widget)
  {
    this->Watched = renderer;
    this->WatchTag = renderer->AddObserver(vtkCommand::StartEvent, widget, &Widget::Update);
  }
  void stopWatching();
  vtkRenderer* watched() { return this->Watched; }

private:
  vtkSmartPointer<vtkAlgorithm> Source;
  int SourcePort = 0;
  vtkSmartPointer<vtkPolyData> SourceSeen;
  vtkMTimeType SourceTime = 0, SystemTime = 0;
  vtkSmartPointer<vtkOversketchSystem> System;
  vtkNew<vtkPolyData> Base, Output;
  vtkNew<vtkTrivialProducer> Producer;
  bool Acted = false;
  Message Said;
  std::string Text;
  vtkWeakPointer<vtkRenderer> Watched;
  unsigned long WatchTag = 0;
};

// Runs it and returns whether that went well, and what it said: the error, else the last warning, which are
// not printed.
OVERSKETCHWIDGETSLIVE_EXPORT std::pair<bool, Message> runAndReport(vtkAlgorithm* system,
  const std::function<void(const Message&)>& warned = nullptr);

} // namespace oversketch
#endif
