#include "edit_step.h"

#include "message_text.h"

#include "vtkOversketchFilterTools.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace oversketch_studio
{

using namespace oversketch_session;

namespace
{

bool isSame(const Input& a, const Input& b)
{
  if (a.index() != b.index())
  {
    return false;
  }
  if (const auto* lines = std::get_if<Lines>(&a))
  {
    return lines->identity() == std::get<Lines>(b).identity();
  }
  if (const auto* image = std::get_if<Image>(&a))
  {
    return image->bytes == std::get<Image>(b).bytes;
  }
  const auto &of = std::get<StepOutput>(a), &ofOther = std::get<StepOutput>(b);
  return of.step == ofOther.step && of.port == ofOther.port;
}

} // namespace

const SystemRow& editRow()
{
  return *findSystem(editSystem);
}

const Image* weightsOf(const Step& step)
{
  const auto weights = step.inputs.find(weightsInput);
  return weights == step.inputs.end() ? nullptr : std::get_if<Image>(&weights->second);
}

bool isSameInput(const Step& a, const Step& b, const std::string& name)
{
  const auto one = a.inputs.find(name), other = b.inputs.find(name);
  const bool has = one != a.inputs.end();
  return has == (other != b.inputs.end()) && (!has || isSame(one->second, other->second));
}

bool isSameData(vtkPolyData* a, vtkPolyData* b)
{
  return a == b || (a && b && oversketch::WholeKey(a) == oversketch::WholeKey(b));
}

std::string editText(const Step& step, const char* property)
{
  return std::get<std::string>(valueOf(step, *findParameter(editRow(), property)));
}

QString wordsOfEdit(const oversketch::Message& message, bool isRing)
{
  const QString line = QCoreApplication::translate("EditHand", "the line"),
                ring = QCoreApplication::translate("EditHand", "the ring"),
                beginsLine = QCoreApplication::translate("EditHand", "The line"),
                beginsRing = QCoreApplication::translate("EditHand", "The ring");
  const std::map<std::string, QString> names{ { "the reference curve", line },
    { "The reference curve", beginsLine },
    { "the boundary curve", ring },
    { "The boundary curve", beginsRing },
    { "the boundary", ring },
    { "The boundary", beginsRing },
    { "Stroke 0 of the reference", beginsLine },
    { "Curve 0 of the reference", beginsLine },
    { "Stroke 0 of the boundary", beginsRing },
    { "Curve 0 of the boundary", beginsRing },
    { "Stroke 0", isRing ? beginsRing : beginsLine },
    { "Curve 0", isRing ? beginsRing : beginsLine } };
  // The first alone: what follows names places in the picture by numbers.
  return plainWords(message.first(),
    [&](const std::string& named)
    {
      const auto known = names.find(named);
      return known == names.end() ? QString() : known->second;
    });
}

double pixelsOf(vtkPolyData* strokes)
{
  if (strokes->GetNumberOfLines() == 0 || strokes->GetPointData()->HasArray("VertexId"))
  {
    return std::numeric_limits<double>::infinity();
  }
  vtkNew<vtkIdList> ids;
  strokes->GetLines()->GetCellAtId(0, ids);
  double length = 0.0;
  for (vtkIdType i = 1; i < ids->GetNumberOfIds(); ++i)
  {
    double from[3], to[3];
    strokes->GetPoint(ids->GetId(i - 1), from);
    strokes->GetPoint(ids->GetId(i), to);
    length += std::hypot(to[0] - from[0], to[1] - from[1]);
  }
  return length;
}

int idOf(const Session& session, const Step& step)
{
  const auto node = std::find_if(session.nodes.rbegin(),
    session.nodes.rend(),
    [&](const Node& one)
    { return isSameInput(*one.step, step, lineInput) && isSameInput(*one.step, step, ringInput); });
  return node == session.nodes.rend() ? 0 : node->id;
}

} // namespace oversketch_studio
