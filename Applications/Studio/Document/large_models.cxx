#include "large_models.h"

#include "document.h"
#include "models.h"

#include <QTimer>

#include <chrono>
#include <exception>
#include <utility>

namespace oversketch_studio
{

using namespace oversketch_session;

namespace
{

constexpr int handRest = 1000; // ms after a result: a hand that goes on needs the processors itself
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
  , Timer(new QTimer(this))
{
  this->Thread.setMaxThreadCount(1);
  this->Timer->setSingleShot(true);
  this->Timer->setInterval(handRest);
  connect(this->Timer, &QTimer::timeout, this, &LargeModels::begin);
  connect(document, &Document::begun, this, [this] { this->Chosen.reset(); });
  connect(document, &Document::detailed, this->Timer, qOverload<>(&QTimer::start));
  connect(document,
    &Document::changed,
    this,
    [this](Document::Change change)
    {
      if (change == Document::Change::Drawn || change == Document::Change::Edited)
      {
        this->end();
      }
    });
}

LargeModels::~LargeModels()
{
  if (this->GivesUp)
  {
    *this->GivesUp = true;
  }
}

std::shared_ptr<ExactResult> LargeModels::resultAt(std::size_t place)
{
  const Session& scene = this->OpenDocument->session();
  const RestingModel* other = restingAt(scene, place);
  const SharedData& shown = other                               ? other->made.mesh
                            : this->OpenDocument->result().mesh ? this->OpenDocument->result().mesh
                                                                : scene.mesh;
  const Model& model = modelAt(scene, place);
  if (!shown)
  {
    return nullptr;
  }
  if (other)
  {
    return std::make_shared<ExactResult>(model, shown);
  }
  if (!this->Chosen || !this->Chosen->isOf(model, shown))
  {
    this->Chosen = std::make_shared<ExactResult>(model, shown);
  }
  return this->Chosen;
}

ExactResults LargeModels::results()
{
  ExactResults results;
  for (std::size_t place = 0; place < modelCount(this->OpenDocument->session()); ++place)
  {
    if (auto result = this->resultAt(place))
    {
      results.push_back(std::move(result));
    }
  }
  return results;
}

void LargeModels::begin()
{
  if (!this->OpenDocument->session().whole || !this->OpenDocument->isSettled())
  {
    return;
  }
  if (!this->Rests())
  {
    this->Timer->start();
    return;
  }
  const std::shared_ptr<ExactResult> result = this->resultAt(this->OpenDocument->session().place);
  if (!result || result->isMade() || this->isMaking())
  {
    return;
  }
  this->GivesUp = std::make_shared<std::atomic<bool>>(false);
  this->Thread.start(
    [this, result, givesUp = this->GivesUp]
    {
      const auto tell = [this, givesUp](double share)
      {
        QMetaObject::invokeMethod(
          this,
          [this, givesUp, share]
          {
            if (givesUp == this->GivesUp)
            {
              share < 1.0 ? void() : this->GivesUp.reset();
              emit this->progressed(share);
            }
          },
          Qt::QueuedConnection);
      };
      try
      {
        result->mesh({ tell, {}, [givesUp] { return givesUp->load(); } });
      }
      catch (const std::exception&)
      {
        // An export makes it again, and says why it cannot.
      }
      tell(1.0);
    });
  emit this->progressed(0.0);
}

void LargeModels::end()
{
  this->Timer->stop();
  if (const auto givesUp = std::exchange(this->GivesUp, nullptr))
  {
    *givesUp = true;
    emit this->progressed(1.0);
  }
}

} // namespace oversketch_studio
