// The words at the window's foot: what to do next, what a step has to say, and the button that does what is
// asked for.
#include "main_window.h"

#include "drawing_pad.h"
#include "history_panel.h"
#include "lesson.h"
#include "message_text.h"
#include "status_labels.h"
#include "system_strings.h"
#include "systems.h"
#include "tool.h"
#include "viewport.h"

#include <QMouseEvent>
#include <QPushButton>

#include <algorithm>
#include <utility>

namespace oversketch_studio
{

using namespace oversketch_session;

// A pen that goes down.
bool MainWindow::eventFilter(QObject* watched, QEvent* event)
{
  if (event->type() == QEvent::MouseButtonPress &&
      static_cast<QMouseEvent*>(event)->button() == Qt::LeftButton)
  {
    this->hush();
  }
  return QMainWindow::eventFilter(watched, event);
}

// Where to draw with the tool in the hand, for who is new to it.
void MainWindow::teach()
{
  const Tool* tool = this->View->tool();
  if (this->ShowsHints && !tool->draws() && !this->View->showsKeys() && this->View->hint() != tool->hint())
  {
    this->View->showHint(tool->hint(), tool->hintShape());
  }
}

void MainWindow::stopTeaching()
{
  this->ShowsHints = false;
  this->View->showHint({});
}

// A hand draws by itself on the lesson's example, and then the learner does.
void MainWindow::playLesson(const Lesson& lesson)
{
  const bool opened = lesson.example.file.isEmpty() ? this->beginDrawing(lesson.example.picture)
                                                    : this->openExample(lesson.example);
  const auto draws = [&](const Tool* tool) { return tool->system() == lesson.system; };
  const auto tool = std::find_if(this->Tools.begin(), this->Tools.end(), draws);
  if (!opened || tool == this->Tools.end())
  {
    return;
  }
  this->setTool(*tool);
  const QWidget* canvas = this->Canvases[this->Tools.indexOf(*tool)];
  auto* pad = canvas ? canvas->findChild<DrawingPad*>() : nullptr;
  this->tried([&] { this->Teacher->play(lesson, pad ? static_cast<FrameView*>(pad) : this->View); });
}

// Takes what a new result has to say: of the last step; else of another that has something new.
void MainWindow::hearRows()
{
  if (this->OpenDocument->isBusy() || !this->OpenDocument->isOpen())
  {
    return;
  }
  const auto& nodes = this->OpenDocument->session().nodes;
  const auto& states = this->OpenDocument->result().nodes;
  const auto before = std::exchange(this->Said, {});
  this->Speaks = -1;
  for (std::size_t i = 0; i < std::min(states.size(), nodes.size()); ++i)
  {
    const oversketch::Message& failure = states[i].failure;
    const oversketch::Message& said = failure.empty() ? states[i].remark : failure;
    if (nodes[i].on && !said.empty())
    {
      this->Said[nodes[i].id] = said;
      const auto known = before.find(nodes[i].id);
      const bool isNew = known == before.end() || known->second != said;
      this->Speaks = isNew || i + 1 == states.size() ? static_cast<int>(i) : this->Speaks;
    }
  }
}

// The hand has gone on: what is at the foot would be read as said of what it draws now.
void MainWindow::hush()
{
  if (std::exchange(this->Speaks, -1) >= 0)
  {
    this->advise();
  }
}

// Whether a row has spoken.
bool MainWindow::speak()
{
  const auto& states = this->OpenDocument->result().nodes;
  const int row = this->Speaks, last = this->OpenDocument->shownTo() - 1;
  const Node* node = this->OpenDocument->nodeAt(row);
  const bool isThere = this->Redrawn < 0 && node && row <= last && states.size() == indexOf(last + 1) &&
                       this->Said.count(node->id) > 0;
  if (!isThere)
  {
    return false;
  }
  const auto& state = states[indexOf(row)];
  const Tool* tool = this->toolOf(row);
  const QString of = row == last ? QString() : tr("%1: ").arg(QString::fromStdString(node->name));
  this->Advice->setText(
    of + (!state.failure.empty() ? tr("That did nothing: %1").arg(briefWords(state.failure))
           : tool                ? tool->words(state.remark) + ' ' + tool->remedy()
                                 : briefWords(state.remark)));
  this->offerAnyway(row, askedFor(state.failure));
  return true;
}

// Where a message asks for an option of its step, a button gives it.
void MainWindow::offerAnyway(int row, const std::string& property)
{
  const Node& node = *this->OpenDocument->nodeAt(row);
  const SystemRow* system = findSystem(node.step->system);
  const Parameter* parameter = system ? findParameter(*system, property) : nullptr;
  const bool can = parameter && std::holds_alternative<bool>(parameter->initial);
  this->Anyway->setVisible(can);
  if (!can)
  {
    return;
  }
  this->Anyway->setText(property == "AllowTorn" ? tr("&Do it anyway")
                        : property == "Arrange" ? tr("&Let lines cross")
                                                : rowText(parameter->title));
  this->Anyway->setToolTip(rowSentence(parameter->help));
  this->OnAnyway = [this, id = node.id, property]
  {
    const int at = rowOf(this->OpenDocument->session().nodes, id);
    if (at >= 0 && !this->View->tool()->isBusy())
    {
      const auto step = this->OpenDocument->nodeAt(at)->step;
      Values values = step->values;
      values[property] = true;
      this->View->setFocus();
      this->OpenDocument->setParameters(at, values, step->mirror);
    }
  };
}

// Says what to do next.
void MainWindow::advise()
{
  this->teach();
  this->Anyway->hide();
  if (this->Teacher->isPlaying())
  {
    this->Advice->setText(this->Teacher->words());
    return;
  }
  Tool::Situation situation;
  const Tool* tool = this->View->tool();
  const int own = tool->node(); // of which the tool speaks itself
  if (tool->judges() && !(own >= 0 && this->Speaks != own && this->speak()))
  {
    this->Advice->setText(tool->advice(situation));
    if (own >= 0)
    {
      this->offerAnyway(own, tool->asked());
    }
    return;
  }
  if (tool->judges())
  {
    return; // another row has spoken
  }
  if (!this->OpenDocument->isOpen())
  {
    this->Advice->setText(tr("Open a model with Ctrl+O, or drop one here."));
    return;
  }
  if (const QString why = this->OpenDocument->whyNoSteps(tool->system()); !why.isEmpty())
  {
    this->Advice->setText(why);
    return;
  }
  if (this->speak())
  {
    return;
  }
  const int row = this->History->current();
  if (tool->system() != "Augment" && this->OpenDocument->isOf(row, "Terrain"))
  {
    this->Advice->setText(tr("Terrain: Scale makes it steeper; B draws ridges and rivers."));
    return;
  }
  situation.empty = this->OpenDocument->session().nodes.empty();
  // Blue and red are of the tool's own steps.
  situation.selected = this->OpenDocument->isOf(row, tool->system());
  situation.holds = this->OpenDocument->isOf(this->Offered, tool->system());
  situation.redraws = this->Redrawn >= 0;
  this->Advice->setText(tool->advice(situation));
}

} // namespace oversketch_studio
