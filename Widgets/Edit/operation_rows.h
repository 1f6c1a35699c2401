// Operations on handles as rows that a hand changes one by one: the text of vtkOversketchHandles read and
// written.
#ifndef oversketch_widgets_edit_operation_rows_h
#define oversketch_widgets_edit_operation_rows_h

#include <string>
#include <vector>

namespace oversketch
{

enum class Verb
{
  Move,
  Scale,
  Rotate,
  Pin,
  Drag // of all of the line, by the host
};

struct OperationRow
{
  Verb verb = Verb::Pin;
  double t = 0.0;      // share of the line's length
  int axis = 0;        // t, w, n
  double amount = 0.0; // length, factor or degrees; of a drag to the right [px]
  double up = 0.0;     // of a drag [px]
};

// Throws Error(BadStroke) naming what is not understood, see handlesOf.
std::vector<OperationRow> operationRows(const std::string& text);
std::string operationText(const std::vector<OperationRow>& rows);
std::string operationText(const OperationRow& row);
// The same for a person: "moved outward 0.1", "turned 54°".
std::string operationWords(const OperationRow& row);

// The row of a handle's axis by a further amount: the same axis again changes its row, another one makes one,
// which takes the place of the handle's pin. A length and an angle add up, a factor multiplies; within what
// is allowed: 179 degrees, factors from 0.05 to 20.
void operate(std::vector<OperationRow>& rows, Verb verb, double t, int axis, double amount);

// The places of handles, ascending, each once; a drag has none.
std::vector<double> handlePlaces(const std::vector<OperationRow>& rows);

} // namespace oversketch
#endif
