// How the selected step acts, or the selected line of a drawing: a form for each system, made of its row in
// the list, and one for lines.
#ifndef oversketch_applications_studio_panels_step_panel_h
#define oversketch_applications_studio_panels_step_panel_h

#include "systems.h"

#include <QStackedWidget>

#include <functional>
#include <map>
#include <string>
#include <vector>

class QComboBox;
class QFormLayout;

namespace oversketch_studio
{

class StepPanel : public QStackedWidget
{
  Q_OBJECT

public:
  explicit StepPanel(QWidget* parent = nullptr);

  // Null: no step is selected; the form that was last seen stays, and can do nothing.
  void show(const oversketch_session::Step* step);
  // Finds the step of a system whose values the form has then; null: none.
  std::function<const oversketch_session::Step*(const std::string& system)> unselected;
  // While none is: the form of a system that the hand now makes steps of.
  void turnTo(const std::string& system);
  // The choice of a mirror plane: none, x, y, z. Its index is what Document::mirrorPlane takes.
  static QComboBox* mirrorChoice(QWidget* parent);

signals:
  // The user has changed something; `mirror` is a choice of mirrorChoice.
  void edited(const oversketch_session::Values& values, int mirror);
  // A field that had the keys can have them no more.
  void keysLeft();

protected:
  // The wheel scrolls the form and changes nothing that is not in use.
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  // A parameter and what it is changed with.
  struct Field
  {
    const oversketch_session::Parameter* parameter = nullptr;
    QWidget* widget = nullptr;
    std::function<oversketch_session::Value(QWidget*)> read;
    std::function<void(QWidget*, const oversketch_session::Value&)> write;
  };
  struct Page
  {
    std::string system;
    QWidget* widget = nullptr;
    std::vector<Field> fields;
    QComboBox* mirror = nullptr;
  };
  void addPage(const oversketch_session::SystemRow& row);
  Field addField(const oversketch_session::Parameter& parameter, QWidget* page, QFormLayout* form);
  void read();

  std::map<std::string, Page> Pages; // by the system's name
  Page* Shown = nullptr;
  oversketch_session::Values StepValues; // of the step that is shown, also those that no field holds
  int StepMirror = 0;                    // of mirrorChoice
};

} // namespace oversketch_studio
#endif
