// The models of a document as they are exported. A large one is worked on by a proxy: its own mesh, under the
// steps that the proxy went through, is made behind the hand.
#ifndef oversketch_applications_studio_document_large_models_h
#define oversketch_applications_studio_document_large_models_h

#include "large_mesh.h"
#include "session.h"

#include <QObject>
#include <QThreadPool>
#include <QTimer>

#include <atomic>
#include <functional>
#include <memory>
#include <vector>

namespace oversketch_studio
{

class Document;

// The result of a model's steps, to the last triangle.
class ExactResult
{
public:
  // `shown` is what they made of the model's mesh.
  ExactResult(const oversketch_session::Model& model, const oversketch_session::SharedData& shown);

  bool isLarge() const { return this->Whole; }
  // Tells whether it is of this model, and shares its points and faces with what is shown.
  bool isOf(const oversketch_session::Model& model, const oversketch_session::SharedData& shown) const;
  bool isMade() const { return this->Share == 1.0; }
  double share() const { return this->Share; }
  // The mesh whose pictures it wears.
  const oversketch_session::SharedData& dressed() const { return this->Whole ? this->Whole : this->Shown; }
  // Makes it, on any thread, told its progress and asked; who comes while another one does waits for it. Null
  // where it was given up.
  oversketch_session::SharedData mesh(const oversketch_session::Progress& progress);

private:
  oversketch_session::SharedData Whole, Shown, Made;
  std::atomic<double> Share{ 0.0 }; // done
  std::timed_mutex Making;
};

using ExactResults = std::vector<std::shared_ptr<ExactResult>>;

class LargeModels : public QObject
{
  Q_OBJECT

public:
  // `rests` says that no hand is drawing.
  LargeModels(Document* document, std::function<bool()> rests);
  ~LargeModels() override;

  // Models that are opened from here on are large with more triangles.
  void setMost(vtkIdType triangles) { this->Most = triangles; }
  vtkIdType most() const { return this->Most; }
  // The result of a model of the scene; null where it has none. Those of all models that have one.
  std::shared_ptr<ExactResult> resultAt(std::size_t place);
  ExactResults results();
  // Whether one is made behind the hand.
  bool isMaking() const { return this->Look.isActive(); }

signals:
  // It is made to that share; 1: it is there, or given up.
  void progressed(double share);

private:
  void begin();
  void end();

  Document* OpenDocument;
  std::function<bool()> Rests;
  vtkIdType Most = oversketch_session::mostTriangles;
  std::shared_ptr<ExactResult> Chosen; // that of the model that is worked on
  // True where the result behind the hand is there, or is to be given up.
  std::shared_ptr<std::atomic<bool>> Ends = std::make_shared<std::atomic<bool>>(true);
  QTimer Rest, Look;
  QThreadPool Thread; // last, so that it ends first
};

} // namespace oversketch_studio
#endif
