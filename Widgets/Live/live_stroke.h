// The stroke that can still be changed, the mesh it was drawn on and the mesh that it made.
#ifndef oversketch_widgets_live_live_stroke_h
#define oversketch_widgets_live_live_stroke_h

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <string>

class vtkAlgorithm;
class vtkAlgorithmOutput;
class vtkOversketchSystem;
class vtkPoints;
class vtkTrivialProducer;

namespace oversketch
{

class LiveStroke
{
public:
  // Of a stroke that somebody else holds and changes: no points while there is none.
  explicit LiveStroke(vtkPolyData* stroke);
  ~LiveStroke();
  LiveStroke(const LiveStroke&) = delete;
  LiveStroke& operator=(const LiveStroke&) = delete;

  // What runs; one has to be set before anything else is asked.
  vtkOversketchSystem* system() const { return this->System; }
  void setSystem(vtkOversketchSystem* system);
  void setSource(vtkAlgorithmOutput* source);
  vtkAlgorithmOutput* outputPort();
  vtkPolyData* output() { return this->Output; }

  bool exists() { return this->Stroke->GetNumberOfPoints() > 0; }
  // It is another one, or has been changed.
  void strokeChanges();
  // The mesh that the stroke made becomes the one that the next is drawn on.
  void commit();
  // The mesh is again as it was before the stroke.
  void drop();

  // Brings the mesh up to date where the source, the stroke or the system has changed. A source that has
  // changed starts anew, without a stroke. Returns whether anything changed.
  bool update();
  // Why the stroke did nothing; empty when it did, or there is none.
  const std::string& message() const { return this->Message; }

  // What the stroke was drawn on, and what it made: the mesh that the next is drawn on.
  vtkPolyData* base() { return this->Base; }
  vtkPolyData* result() { return this->Result; }
  // Asks the system for a preview, which changes none of its parameters.
  void ask(const std::function<void()>& question);
  // A place in the middle of what the stroke took hold of; of the mesh where it did not. False without a
  // stroke.
  bool middle(double place[3]);
  // The part of the present mesh that moved; empty where there is none.
  vtkSmartPointer<vtkPolyData> region();

  // Shows the mesh with the stroke moved by a vector [world], where the system can tell; the way back.
  void drag(const double translation[3]);
  void endDrag();

private:
  void run();

  vtkSmartPointer<vtkAlgorithm> Source;
  int SourcePort = 0;
  vtkSmartPointer<vtkPolyData> SourceSeen;
  vtkMTimeType SourceTime = 0, SystemTime = 0;
  vtkSmartPointer<vtkOversketchSystem> System;
  vtkSmartPointer<vtkPolyData> Stroke;
  vtkNew<vtkPolyData> Base, Result, Output;
  vtkNew<vtkTrivialProducer> Producer;
  vtkSmartPointer<vtkPoints> Dragged; // null while the output is the result
  vtkNew<vtkPolyData> Held;           // what the last run took hold of
  bool Stale = false, Acted = false;
  std::string Message;
};

} // namespace oversketch
#endif
