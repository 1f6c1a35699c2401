#include "drawing_tool.h"

#include "document.h"
#include "drawing_pad.h"
#include "flow_layout.h"
#include "focus_frame.h"
#include "long_work.h"
#include "message_text.h"
#include "systems.h"
#include "viewport.h"

#include "vtkOversketchDrawingWidget.h"
#include "vtkOversketchInteractorStyle.h"

#include "Raster/classify.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkPolyData.h"

#include <QAction>
#include <QCheckBox>
#include <QTimer>
#include <QToolButton>

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace oversketch_studio
{

using namespace oversketch_session;

namespace
{

constexpr int closedFeature = 2;     // cell array Role
constexpr int picturePatience = 100; // ms

int countOf(vtkPolyData* curves, int role)
{
  vtkDataArray* roles = curves->GetCellData()->GetArray("Role");
  int count = 0;
  for (vtkIdType i = 0; roles && i < roles->GetNumberOfTuples(); ++i)
  {
    count += static_cast<int>(roles->GetComponent(i, 0)) == role;
  }
  return count;
}

} // namespace

DrawingTool::DrawingTool(Viewport* viewport, const Document* document)
  : Tool(viewport)
  , View(viewport)
  , OpenDocument(document)
  , Handles(viewport)
  , Magnetic(new QAction(tr("&Magnetic pen"), this))
  , Deepen(new QAction(tr("Next &depth"), this))
  , Swap(new QAction(tr("S&wap sides"), this))
{
  this->setObjectName("drawing");
  this->Magnetic->setObjectName("magnetic");
  this->Magnetic->setCheckable(true);
  this->Magnetic->setChecked(true);
  this->Magnetic->setShortcut(QKeySequence(tr("F4")));
  this->Magnetic->setToolTip(tr("New lines move to the picture's edges beside them, when the pen goes up"));
  this->Deepen->setShortcut(QKeySequence(tr("F5")));
  this->Deepen->setToolTip(
    tr("The closed line that was drawn last, or is selected, bounds a body on both sides, in front, behind"));
  this->Swap->setObjectName("swap");
  this->Swap->setIconText(tr("Swap sides (V)"));
  this->Swap->setShortcut(QKeySequence(tr("V")));
  this->Swap->setToolTip(tr("Picture and model change sides"));
  connect(this->Magnetic,
    &QAction::toggled,
    this,
    [this](bool on)
    {
      if (this->Pad)
      {
        this->Pad->widget()->SetMagnetic(on);
      }
      emit this->left();
    });
  this->Handles.moved = [this](const PartPlace& place, bool mergesIntoLast)
  { emit this->placed(this->node(), place, mergesIntoLast); };
  this->Handles.givenUp = [this] { emit Tool::givenUp(); };
  connect(this->Deepen, &QAction::triggered, this, &DrawingTool::deepen);
  connect(this->Swap, &QAction::triggered, this, &Tool::swapAsked);
  connect(document, &Document::opened, this, &DrawingTool::follow);
  connect(document, &Document::changed, this, &DrawingTool::follow);
}

// A picture's corner, a line round something in it.
QPainterPath DrawingTool::icon() const
{
  QPainterPath path;
  path.addRect(2, 3, 20, 18);
  path.moveTo(7, 15);
  path.cubicTo(4, 10, 8, 6, 12, 8);
  path.cubicTo(16, 5, 21, 9, 17.5, 13);
  path.cubicTo(16, 18, 9, 19, 7, 15);
  return path;
}

QVector<QPair<QString, QString>> DrawingTool::keys() const
{
  return {
    { tr("In the picture:"), {} },
    { tr("  Left drag"), tr("draw a line; close an outline") },
    { tr("  Shift + left drag"), tr("over a line: redraw a part of it") },
    { tr("  Left click"), tr("on a shape: trace its outline; in a closed inner line: fill, hole, tunnel") },
    { tr("  Wheel, middle drag"), tr("zoom, pan") },
    { tr("F5"), tr("depth of what a closed line bounds") },
    { tr("F4, V"), tr("magnet on or off; views change sides") },
    { tr("Over the model:"), tr("left drag: turn it") },
    { tr("  On a part's handle"), tr("move it; a corner: its size, Shift: freely; orange: its depth") },
  };
}

QString DrawingTool::need() const
{
  if (this->lacksPicture())
  {
    return tr("The picture under this drawing has not been read. G reads it.");
  }
  const bool anyOn =
    std::any_of(this->Strokes.begin(), this->Strokes.end(), [](const DrawnStroke& one) { return one.on; });
  if (this->Strokes.empty())
  {
    return this->Picture
             ? tr("Draw round the shape in the picture, ending where it began, or click on it: it "
                  "becomes a model. F4 turns the magnet to edges %1, F1 lists the keys.")
                 .arg(this->Magnetic->isChecked() ? tr("off") : tr("on"))
             : tr("Draw an outline, one line that ends where it began: it becomes a model. F1 "
                  "lists the keys.");
  }
  if (!anyOn)
  {
    return tr("All lines of the drawing are off. Tick one in the list.");
  }
  vtkDataArray* closed = this->Pad->widget()->GetCurves()->GetCellData()->GetArray("Closed");
  if (closed && closed->GetRange(0)[1] == 0.0)
  {
    return this->Arranged
             ? tr("Close the outline: end it where it began, or draw what is missing.")
             : tr("Close the outline: end it where it began, or draw what is missing with Shift from one end "
                  "to the other. Outlines of several lines: tick Strokes may cross.");
  }
  return {};
}

QVector<int> DrawingTool::linesOn() const
{
  QVector<int> lines;
  for (std::size_t i = 0; i < this->Strokes.size(); ++i)
  {
    if (this->Strokes[i].on)
    {
      lines << static_cast<int>(i);
    }
  }
  return lines;
}

int DrawingTool::closedLine() const
{
  const QVector<int> lines = this->linesOn();
  const int line = lines.contains(this->Line) ? this->Line : lines.value(lines.size() - 1, -1);
  vtkCellData* said = this->Pad ? this->Pad->widget()->GetCurves()->GetCellData() : nullptr;
  vtkDataArray* strokes = said ? said->GetArray("StrokeId") : nullptr;
  vtkDataArray* closed = said ? said->GetArray("Closed") : nullptr;
  for (vtkIdType i = 0; strokes && closed && i < strokes->GetNumberOfTuples(); ++i)
  {
    if (closed->GetComponent(i, 0) != 0.0 &&
        lines.value(static_cast<int>(strokes->GetComponent(i, 0)), -1) == line)
    {
      return line;
    }
  }
  return -1;
}

// A limb and its twin come first.
void DrawingTool::deepen()
{
  constexpr int next[] = { 3, 2, 0, 1 };
  const int at = this->node(), line = this->closedLine();
  if (at < 0 || line < 0 || this->draws())
  {
    return;
  }
  std::vector<DrawnStroke> lines = this->Strokes;
  vtkSmartPointer<vtkPolyData>& own = lines[indexOf(line)].line;
  own = withDepth(own, next[std::clamp(depthOf(own), 0, 3)], heightOf(own), crossSectionOf(own));
  const Step& step = *this->OpenDocument->nodeAt(at)->step;
  emit this->edited(at, withDrawing(step, drawingOf(lines, linesOf(step, strokesInput))));
}

QString DrawingTool::inLines(const oversketch::Message& message) const
{
  const QVector<int> lines = this->linesOn();
  return plainWords(message,
    [&](const std::string& named) -> QString
    {
      const std::string what = named.substr(0, named.find(' '));
      if (what != "Stroke" && what != "stroke")
      {
        return {};
      }
      const int line = lines.value(std::atoi(named.c_str() + what.size()), -1) + 1;
      return (what == "Stroke" ? tr("Line %1") : tr("line %1")).arg(line);
    });
}

// All but a remark on a model that has been made is the tool's to say.
bool DrawingTool::judges() const
{
  const int at = this->node();
  const auto& states = this->OpenDocument->result().nodes;
  const bool isMade = at >= 0 && this->Pad && indexOf(at) < states.size() && this->Redrawn < 0 &&
                      states[indexOf(at)].failure.empty() && !states[indexOf(at)].remark.empty();
  return !isMade || !this->need().isEmpty() || !this->Pad->widget()->GetSaid().empty();
}

bool DrawingTool::isCrossing() const
{
  const std::string said = this->Pad ? this->Pad->widget()->GetSaid().first().id() : "";
  return !this->Arranged && (said == oversketch::crossesText || said == oversketch::crossesItselfText);
}

std::string DrawingTool::asked() const
{
  const char* const crossing = "Arrange";
  return this->isCrossing() ? crossing : "";
}

QString DrawingTool::advice(const Situation&) const
{
  const int at = this->node();
  if (at < 0 || !this->Pad)
  {
    return tr("File > New from picture, or drop a picture here: what you draw over it becomes a model.");
  }
  if (this->Redrawn >= 0)
  {
    return tr("Redraw line %1, whole. G leaves it as it is.").arg(this->Redrawn + 1);
  }
  QString lacks = this->need();
  if (!lacks.isEmpty())
  {
    return lacks;
  }
  const auto& states = this->OpenDocument->result().nodes;
  const QString wrong = this->inLines(this->Pad->widget()->GetSaid().first()); // the picture has all of them
  if (!wrong.isEmpty())
  {
    if (this->Pad->widget()->GetSaid().first().named().empty())
    {
      return wrong; // of what was asked for last, which changed nothing
    }
    if (const int line = this->closedLine(); this->isCrossing() && line > 0)
    {
      return tr(
        "%1 F5 makes line %2 a body on both sides, in front or behind; Ctrl+Z takes the last line back; "
        "or tick Strokes may cross.")
        .arg(wrong)
        .arg(line + 1);
    }
    return this->isCrossing()
             ? tr("%1 Ctrl+Z takes the last line back; or tick Strokes may cross.").arg(wrong)
             : tr("%1 Ctrl+Z takes the last line back.").arg(wrong);
  }
  if (indexOf(at) < states.size() && !states[indexOf(at)].failure.empty() && !this->OpenDocument->isBusy())
  {
    return tr("The last model stays: %1").arg(this->inLines(states[indexOf(at)].failure));
  }
  if (this->OpenDocument->nodeAt(at)->step->part)
  {
    return tr("Over the model: drag the box's middle to move the part, a corner for its size, the orange "
              "handle for its depth. D pulls a limb of the model.");
  }
  if (const int line = this->closedLine(); line > 0)
  {
    return tr(
      "F5 puts line %1 on both sides, in front, behind, in the plane, in turn. Click in an inner line: "
      "hole, tunnel, filled again. Shift + drag over a line redraws a part of it.")
      .arg(line + 1);
  }
  if (countOf(this->Pad->widget()->GetCurves(), closedFeature) > 0)
  {
    return tr("Click in the inner line: hole, tunnel, filled again. Shift + drag over a line redraws a part "
              "of it. D pulls a limb of the model.");
  }
  return tr("Draw a feature inside, or a closed line that a click makes a hole. Shift + drag over a line "
            "redraws a part of it. D pulls a limb of the model.");
}

QString DrawingTool::stage(const QString& name) const
{
  if (QStringList{ "Inflate", "Extrude", "Tunnel", "ProjectTexture" }.contains(name))
  {
    return tr("Inflating");
  }
  if (name == "Trace" ||
      QStringList{ "Canvas", "MagneticSnap", "Resample", "Arrange", "Classify", "Treatment" }.contains(name))
  {
    return tr("Reading the drawing");
  }
  return name == "Distance" ? tr("Measuring the thickness") : tr("Making triangles");
}

QWidget* DrawingTool::makeOptions(QWidget* parent)
{
  auto* options = new QWidget(parent);
  auto* row = new FlowLayout(options);
  row->setContentsMargins(6, 0, 6, 0);
  auto* magnetic = new QCheckBox(tr("Magnetic pen (F4)"), options);
  magnetic->setToolTip(this->Magnetic->toolTip());
  magnetic->setChecked(this->Magnetic->isChecked());
  connect(magnetic, &QCheckBox::toggled, this->Magnetic, &QAction::setChecked);
  connect(this->Magnetic, &QAction::toggled, magnetic, &QCheckBox::setChecked);
  connect(this->Magnetic,
    &QAction::changed,
    magnetic,
    [this, magnetic] { magnetic->setEnabled(this->Magnetic->isEnabled()); });
  row->addWidget(magnetic);
  auto* swap = new QToolButton(options);
  swap->setDefaultAction(this->Swap);
  row->addWidget(swap);
  return options;
}

QWidget* DrawingTool::makeCanvas(QWidget* parent)
{
  this->Pad = new DrawingPad;
  auto* frame = new FocusFrame(this->Pad, parent);
  frame->hide();
  connect(this->Pad, &DrawingPad::changed, this, &DrawingTool::take);
  connect(this->Pad, &DrawingPad::began, this->View, &Viewport::hideHint);
  connect(this->Pad, &DrawingPad::ended, this, &Tool::left);
  return frame;
}

int DrawingTool::node() const
{
  if (!this->OpenDocument->isOpen())
  {
    return -1;
  }
  const auto& nodes = this->OpenDocument->session().nodes;
  const int selected = rowOf(nodes, this->Drawing);
  if (this->OpenDocument->isOf(selected, drawingSystem))
  {
    return selected;
  }
  const auto first = std::find_if(
    nodes.begin(), nodes.end(), [](const Node& one) { return one.step->system == drawingSystem; });
  return first == nodes.end() ? -1 : static_cast<int>(first - nodes.begin());
}

void DrawingTool::select(int node)
{
  const Node* one = this->OpenDocument->nodeAt(node);
  if (one && one->step->system == drawingSystem && one->id != this->Drawing)
  {
    this->Drawing = one->id;
    this->follow();
  }
}

void DrawingTool::selectLine(int line)
{
  this->Line = line;
  this->Deepen->setEnabled(this->Held && this->closedLine() >= 0);
}

void DrawingTool::start()
{
  this->Held = true;
  this->Started = this->Started && !this->lacksPicture(); // which is asked for again
  this->View->camera()->SetModeToNavigate();
  this->View->setHandCursor(Qt::OpenHandCursor);
  this->follow();
}

void DrawingTool::stop()
{
  this->Held = false;
  this->Redrawn = -1;
  this->follow();
}

bool DrawingTool::draws() const
{
  return this->Pad && this->Pad->isDrawing();
}

void DrawingTool::setSteadiness(double pixels)
{
  if (this->Pad)
  {
    this->Pad->setSteadiness(pixels);
  }
}

void DrawingTool::setDark(bool dark)
{
  if (this->Pad)
  {
    this->Pad->setDark(dark);
  }
}

void DrawingTool::follow()
{
  const int at = this->node();
  if (!this->Pad)
  {
    return;
  }
  this->Pad->parentWidget()->setVisible(this->Held && at >= 0);
  this->Swap->setEnabled(this->Held && at >= 0);
  this->Magnetic->setEnabled(this->Held && at >= 0 && this->Picture);
  this->Deepen->setEnabled(false);
  if (at < 0)
  {
    this->Handles.show(std::nullopt);
    this->Drawing = this->OnPad = 0;
    this->Started = false;
    this->Shown = nullptr;
    this->Decoded = nullptr;
    this->Strokes.clear();
    return;
  }
  const Node& node = *this->OpenDocument->nodeAt(at);
  const Step& step = *node.step;
  this->Handles.show(this->Held ? step.part : std::nullopt);
  this->Drawing = node.id;
  this->Started = std::exchange(this->OnPad, node.id) == node.id && this->Started;
  const auto lines = step.inputs.find(strokesInput);
  const Lines* drawn = lines == step.inputs.end() ? nullptr : std::get_if<Lines>(&lines->second);
  const vtkSmartPointer<vtkPolyData> drawing = drawn ? drawn->own() : nullptr;
  const Image* image = pictureUnder(step);
  const auto bytes = image ? image->bytes : nullptr;
  if (this->Held && (!this->Started || bytes != this->Picture))
  {
    this->Started = true;
    this->Shown = nullptr; // after the picture
    this->Picture = bytes;
    this->Magnetic->setEnabled(bytes != nullptr);
    this->Decoded = bytes ? findDecoded(*bytes) : nullptr;
    vtkDataArray* canvas = drawing ? drawing->GetFieldData()->GetArray("Canvas") : nullptr;
    this->Pad->setEnabled(!this->lacksPicture());
    if (this->Decoded)
    {
      this->Pad->setPicture(this->Decoded->pixels);
    }
    else if (canvas && canvas->GetNumberOfValues() == 4)
    {
      const auto value = [canvas](int i) { return canvas->GetVariantValue(i).ToDouble(); };
      this->Pad->setCanvas(value(0), value(1), value(2), value(3));
    }
    else
    {
      this->Pad->setPicture(nullptr);
    }
    if (this->lacksPicture())
    {
      // Not here: whoever has changed the document is not done with it.
      QMetaObject::invokeMethod(this, &DrawingTool::readPicture, Qt::QueuedConnection);
    }
  }
  const SystemRow* row = findSystem(drawingSystem);
  const Parameter* crossing = findParameter(*row, "Arrange");
  const bool arranged = std::get<bool>(valueOf(step, *crossing));
  const bool judgedAnew = std::exchange(this->Arranged, arranged) != arranged;
  this->Pad->widget()->SetArrange(arranged);
  const auto identity = drawn ? drawn->identity() : nullptr;
  const bool isOther = identity != this->Shown;
  if (isOther)
  {
    this->Shown = identity;
    this->Redrawn = -1;
    this->Strokes = strokesOf(drawing);
    this->Pad->widget()->SetDrawing(drawing ? strokesThatAreOn(drawing) : nullptr);
  }
  if (isOther || judgedAnew)
  {
    this->Pad->showText(this->inLines(this->Pad->widget()->GetSaid()));
  }
  this->selectLine(this->Line);
}

// Reads that of the drawing that has been taken up, where nobody has it yet.
void DrawingTool::readPicture()
{
  if (!longWorkGoing().isEmpty())
  {
    QTimer::singleShot(picturePatience, this, &DrawingTool::readPicture);
    return;
  }
  const int at = this->node();
  const PictureBytes bytes = this->Picture;
  if (!this->Held || at < 0 || !this->lacksPicture())
  {
    return;
  }
  const Image* image = pictureUnder(*this->OpenDocument->nodeAt(at)->step);
  if (!image || image->bytes != bytes)
  {
    return; // of another drawing
  }
  const auto read = std::make_shared<SharedPicture>();
  const bool done = doLongWork(this->Pad->window(),
    tr("Reading %1…").arg(QString::fromStdString(image->name)),
    [read, bytes] { *read = decoded(bytes); });
  if (done)
  {
    this->Started = false;
    this->follow();
  }
  emit this->left(); // says what is next
}

void DrawingTool::take()
{
  const int at = this->node();
  if (at < 0)
  {
    return;
  }
  // Those that are off were not on the pad; what is new there comes last.
  const std::vector<DrawnStroke> now = strokesOf(this->Pad->widget()->GetDrawing());
  std::vector<DrawnStroke> next = this->Strokes;
  std::size_t k = 0;
  for (DrawnStroke& stroke : next)
  {
    if (stroke.on && k < now.size())
    {
      stroke.line = now[k++].line;
    }
  }
  const bool replaces = k < now.size() && this->Redrawn >= 0 && indexOf(this->Redrawn) < next.size();
  if (replaces)
  {
    vtkSmartPointer<vtkPolyData>& line = next[indexOf(this->Redrawn)].line;
    const vtkSmartPointer<vtkPolyData> before = std::exchange(line, now[k].line);
    ++k;
    for (const char* name : { treatmentArray, depthArray, heightArray, sectionArray })
    {
      if (vtkDataArray* said = before->GetCellData()->GetArray(name))
      {
        line->GetCellData()->AddArray(said); // a hole stays one, a limb its twin's
      }
    }
  }
  this->Line = k < now.size() ? -1 : this->Line; // the last one
  next.insert(next.end(), now.begin() + static_cast<std::ptrdiff_t>(k), now.end());
  const Step step =
    withDrawing(*this->OpenDocument->nodeAt(at)->step, drawingOf(next, this->Pad->widget()->GetDrawing()));
  if (!replaces) // the pad shows it already
  {
    this->Strokes = next;
    this->Shown = std::get<Lines>(step.inputs.at(strokesInput)).identity();
    this->Pad->showText(this->inLines(this->Pad->widget()->GetSaid()));
  }
  emit this->edited(at, step);
}

} // namespace oversketch_studio
