#include "system_strings.h"

#include "drawing_lines.h"
#include "systems.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <utility>

namespace oversketch_studio
{

using namespace oversketch_session;

namespace
{

struct RowTexts
{
  Q_DECLARE_TR_FUNCTIONS(Rows)
};

const char* const terrainSystem = "Terrain";
const char* const editSystemName = "Edit";
const char* const maskSystemName = "Mask";
const char* const poseSystemName = "Pose";
const char* const joinSystemName = "Join";

// "12 %", also where that is less than half a hundredth.
QString shareOf(double share)
{
  const int percent = static_cast<int>(std::lround(100.0 * share));
  return percent == 0 ? RowTexts::tr("under 1 %") : RowTexts::tr("%1 %").arg(percent);
}

QString deedOf(const Step& step, const Worker::NodeState& state)
{
  if (step.system == drawingSystem)
  {
    const auto lines = strokesOf(step);
    const auto on =
      std::count_if(lines.begin(), lines.end(), [](const DrawnStroke& line) { return line.on; });
    return on == 1 ? RowTexts::tr("makes a body of one line")
                   : RowTexts::tr("makes a body of %1 lines").arg(on);
  }
  if (step.system == terrainSystem)
  {
    return RowTexts::tr("makes the ground of it");
  }
  if (step.system == maskSystemName)
  {
    return RowTexts::tr("keeps a part as it is");
  }
  if (step.system == joinSystemName)
  {
    return RowTexts::tr("makes one body of parts");
  }
  if (!state.region)
  {
    return {};
  }
  if (step.system == editSystemName && state.share == 0.0)
  {
    return RowTexts::tr("ready: drag its line");
  }
  if (step.system == poseSystemName && state.share == 0.0)
  {
    return RowTexts::tr("ready: draw where it is to go");
  }
  const SystemRow* system = findSystem(step.system);
  const Parameter* height = system ? findParameter(*system, "Height") : nullptr;
  const auto* value = height ? std::get_if<double>(&valueOf(step, *height)) : nullptr;
  const QString share = shareOf(state.share);
  const QString deed = !value         ? RowTexts::tr("moves %1 of the model").arg(share)
                       : *value < 0.0 ? RowTexts::tr("carves %1 of the model").arg(share)
                                      : RowTexts::tr("raises %1 of the model").arg(share);
  return step.mirror ? RowTexts::tr("%1, mirrored").arg(deed) : deed;
}

} // namespace

QString rowText(const std::string& text)
{
  return text.empty() ? QString() : QCoreApplication::translate("Systems", text.c_str());
}

QString rowSentence(const std::string& text)
{
  QString sentence = rowText(text);
  return sentence.isEmpty() ? sentence : sentence[0].toUpper() + sentence.mid(1);
}

QString titleOf(const std::string& system)
{
  const auto* row = findSystem(system);
  return row ? rowText(row->title) : QString::fromStdString(system);
}

Node firstNode(std::shared_ptr<const Step> step)
{
  Node node;
  node.id = 1;
  node.name = titleOf(step->system).toStdString();
  node.step = std::move(step);
  return node;
}

QStringList listOf(const std::vector<std::string>& texts)
{
  QStringList list;
  for (const std::string& text : texts)
  {
    list << QString::fromStdString(text);
  }
  return list;
}

QStringList wrapped(const QString& text, int most)
{
  QStringList lines;
  for (const QString& word : text.split(' '))
  {
    if (lines.isEmpty() || lines.last().size() + 1 + word.size() > most)
    {
      lines << word;
    }
    else
    {
      lines.last() += ' ' + word;
    }
  }
  return lines;
}

QString wordsOf(const Node& node, const Worker::NodeState* state)
{
  if (!node.on)
  {
    return RowTexts::tr("off");
  }
  if (!state)
  {
    return RowTexts::tr("not shown");
  }
  const bool isEmpty = node.step->system == drawingSystem && strokesOf(*node.step).empty();
  if (!state->failure.empty())
  {
    return isEmpty ? RowTexts::tr("nothing drawn yet") : RowTexts::tr("did nothing");
  }
  const QString deed = deedOf(*node.step, *state);
  // A remark has a mark instead.
  return !state->elsewhere ? deed
         : deed.isEmpty()  ? RowTexts::tr("elsewhere")
                           : RowTexts::tr("elsewhere; %1").arg(deed);
}

QString whyNotBefore(const Node& step, const Node& needed)
{
  return RowTexts::tr("“%1” needs “%2”, which stays before it.")
    .arg(QString::fromStdString(step.name), QString::fromStdString(needed.name));
}

} // namespace oversketch_studio
