#include "large_models.h"

#include "document.h"
#include "models.h"

#include <chrono>
#include <exception>

namespace oversketch_studio
{

using namespace oversketch_session;

namespace
{

constexpr int handRest = 1000; // ms after a result: a hand that goes on needs the processors itself
constexpr int tellAfter = 100; // ms
constexpr std::chrono::milliseconds askAgainAfter{ 50 };
constexpr double almostMade = 0.99; // before it is there

} // namespace

ExactResult::ExactResult(const Model& model, const SharedData& shown)
  : Whole(model.whole)
  , Shown(shown)
{
  if (!this->Whole || shown->GetPoints() == model.mesh->GetPoints())
  {
    this->Made = this->dressed(); // no step has moved it
    this->Share = 1.0;
  }
}

bool ExactResult::isOf(const Model& model, const SharedData& shown) const
{
  return this->Whole.identity() == model.whole.identity() && this->Shown->GetPoints() == shown->GetPoints() &&
         this->Shown->GetPolys() == shown->GetPolys();
}

SharedData ExactResult::mesh(const Progress& progress)
{
  std::unique_lock<std::timed_mutex> lock(this->Making, std::defer_lock);
  while (!lock.try_lock_for(askAgainAfter))
  {
    if (progress.cancelled())
    {
      return {};
    }
    progress.progress(this->Share); // of the other
  }
  if (!this->Made)
  {
    Progress both = progress;
    both.progress = [&](double share)
    {
      this->Share = almostMade * share;
      progress.progress(this->Share);
    };
    this->Made = exactOf(withOwnPolys(this->Whole), withOwnPolys(this->Shown), both);
    this->Share = this->Made ? 1.0 : 0.0;
  }
  return this->Made;
}

LargeModels::LargeModels(Document* document, std::function<bool()> rests)
  : QObject(document)
  , OpenDocument(document)
  , Rests(std::move(rests))
{
  this->Thread.setMaxThreadCount(1);
  this->Rest.setSingleShot(true);
  this->Rest.setInterval(handRest);
  this->Look.setInterval(tellAfter);
  connect(&this->Rest, &QTimer::timeout, this, &LargeModels::begin);
  connect(&this->Look,
    &QTimer::timeout,
    this,
    [this] { *this->Ends ? this->end() : emit this->progressed(this->Chosen->share()); });
  connect(document, &Document::detailed, &this->Rest, qOverload<>(&QTimer::start));
  connect(document,
    &Document::changed,
    this,
    [this](Document::Change change)
    { change == Document::Change::Drawn || change == Document::Change::Edited ? this->end() : void(); });
  connect(document, &Document::begun, this, [this] { this->Chosen.reset(); });
}

LargeModels::~LargeModels()
{
  *this->Ends = true;
}

std::shared_ptr<ExactResult> LargeModels::resultAt(std::size_t place)
{
  const Session& scene = this->OpenDocument->session();
  const Model& model = modelAt(scene, place);
  const RestingModel* other = restingAt(scene, place);
  const SharedData& made = other ? other->made.mesh : this->OpenDocument->result().mesh;
  const SharedData& shown = made ? made : model.mesh;
  if (!shown || (!other && this->Chosen && this->Chosen->isOf(model, shown)))
  {
    return shown ? this->Chosen : nullptr;
  }
  auto result = std::make_shared<ExactResult>(model, shown);
  this->Chosen = other ? this->Chosen : result;
  return result;
}

ExactResults LargeModels::results()
{
  ExactResults results;
  for (std::size_t place = 0; place < modelCount(this->OpenDocument->session()); ++place)
  {
    auto result = this->resultAt(place);
    result ? results.push_back(std::move(result)) : void();
  }
  return results;
}

void LargeModels::begin()
{
  const Session& scene = this->OpenDocument->session();
  if (!scene.whole || !this->OpenDocument->isSettled() || this->isMaking() ||
      this->resultAt(scene.place)->isMade())
  {
    return;
  }
  if (!this->Rests())
  {
    this->Rest.start();
    return;
  }
  this->Ends = std::make_shared<std::atomic<bool>>(false);
  this->Thread.start(
    [result = this->Chosen, ends = this->Ends]
    {
      try
      {
        result->mesh({ [](double) {}, {}, [ends] { return ends->load(); } });
      }
      catch (const std::exception&)
      {
        // An export makes it again, and says why it cannot.
      }
      *ends = true;
    });
  this->Look.start();
  emit this->progressed(0.0);
}

void LargeModels::end()
{
  *this->Ends = true;
  this->Rest.stop();
  this->Look.stop();
  emit this->progressed(1.0);
}

} // namespace oversketch_studio
