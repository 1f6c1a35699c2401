// The window's rows of the history, and their lines on the model.
#include "main_window.h"

#include "held_stroke_tool.h"
#include "history_panel.h"
#include "status_labels.h"
#include "step_lines.h"
#include "stroke_lines.h"
#include "view_keys.h"
#include "viewport.h"

#include <QApplication>

namespace oversketch_studio
{

using namespace oversketch_session;

// Before the window hears of the document, so that a new mesh is not drawn with the lines of the last.
void MainWindow::listenToRows()
{
  const auto follow = [this] { this->Lines->set(this->OpenDocument->traces()); };
  connect(this->OpenDocument, &Document::shown, this, follow);
  connect(this->OpenDocument, &Document::traced, this, follow);
  connect(this->OpenDocument, &Document::opened, this, follow);
  connect(this->Lines, &StrokeLines::clicked, this, &MainWindow::clicked);
  connect(this->View, &Viewport::linesShown, this->Lines, &StrokeLines::setVisible);
  connect(this->History, &HistoryPanel::told, this->Advice, &AdviceLabel::setText);
  for (Tool* tool : this->Tools)
  {
    connect(tool, &Tool::tooShort, this, &MainWindow::tooShort);
    connect(tool, &Tool::refused, this, &MainWindow::refuseLine);
  }
  auto* keys = new ViewKeys(this->View, [this] { return this->View->tool()->isBusy(); });
  connect(keys,
    &ViewKeys::escaped,
    this,
    [this]
    {
      // The tool comes first.
      const bool isFree = !this->View->tool()->isBusy() && QApplication::mouseButtons() == Qt::NoButton;
      if (isFree && this->leavesRows())
      {
        this->History->selectStep(-1);
      }
    });
  connect(this->History, &HistoryPanel::keysLeft, this, [this] { this->View->setFocus(); });
  this->View->addAction(this->History->removal());
}

// A tool that has a use for both of its own steps leaves those of others.
bool MainWindow::leavesRows() const
{
  const Tool* tool = this->View->tool();
  const Node* row = this->OpenDocument->nodeAt(this->History->current());
  return tool->leavesRows() || (row && row->step->system != tool->system());
}

// A line that is seen is selected; else what is selected is left.
void MainWindow::clicked(const QPoint& place, int line)
{
  Tool* tool = this->View->tool();
  if (this->chooseModelAt(place))
  {
    return;
  }
  if (!this->OpenDocument->isOpen() || !this->leavesRows())
  {
    return;
  }
  const double ratio = this->View->devicePixelRatioF();
  const bool isHeld = tool->holds(ratio * place.x(), ratio * (this->View->height() - 1 - place.y()));
  const int step = isHeld ? this->Offered : line;
  if (step != this->History->current())
  {
    this->History->selectStep(step);
  }
}

void MainWindow::tooShort(double least)
{
  this->refuseLine(tr("Too short: draw at least %1 px.").arg(least));
}

void MainWindow::refuseLine(const QString& why)
{
  this->offerStep(); // which the pen has let go of
  this->Advice->setText(why);
}

// The selected step's; else that of the step that the tool in the hand lets be taken hold of.
void MainWindow::chooseLine()
{
  const Tool* tool = this->View->tool();
  const bool turns = tool->system().empty(), pens = qobject_cast<const HeldStrokeTool*>(tool);
  this->Lines->showAll(turns);
  int step = this->History->current();
  if (step < 0 && this->OpenDocument->nodeAt(this->Offered) && this->toolOf(this->Offered) == tool)
  {
    step = this->Offered;
  }
  const Node* chosen = turns || pens ? this->OpenDocument->nodeAt(step) : nullptr;
  if (!chosen)
  {
    this->Lines->choose(-1, nullptr);
    return;
  }
  const bool isHeld = step == this->Offered && tool->system() == chosen->step->system;
  this->Lines->choose(step, isHeld ? strokeOf(this->OpenDocument->session(), *chosen->step).Get() : nullptr);
}

} // namespace oversketch_studio
