// Export for print: what a check of the model found, in words and in the view's colours, its size and format.
#ifndef oversketch_applications_studio_window_print_dialog_h
#define oversketch_applications_studio_window_print_dialog_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <QDialog>

#include <functional>

class QDoubleSpinBox;
class QLabel;
class QPushButton;
class vtkOversketchPrintCheck;

namespace oversketch_studio
{

class PrintDialog : public QDialog
{
  Q_OBJECT

public:
  // Takes a check that has run; `up`: the world's axis that is, 1 for y, 2 for z. `show` is given the model
  // with its walls by colour, now and whenever that changes. Accepted, it is to be written, ready or not.
  PrintDialog(vtkOversketchPrintCheck* check,
    int up,
    const std::function<void(vtkPolyData*)>& show,
    QWidget* parent);
  ~PrintDialog() override;

  // The mesh in millimetres as it stands on a printer's table: z is up, all coordinates are 0 or more.
  vtkSmartPointer<vtkPolyData> printed() const;

private:
  void tell();
  double extent() const;      // upward [length]
  double millimetres() const; // of a length of 1

  vtkSmartPointer<vtkOversketchPrintCheck> Check;
  int Up;
  std::function<void(vtkPolyData*)> Show;
  QDoubleSpinBox *Height, *Wall;
  QLabel *Words, *Verdict;
  QPushButton* Write;
};

} // namespace oversketch_studio
#endif
