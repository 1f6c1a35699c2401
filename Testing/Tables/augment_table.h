// Table I of the paper of system D, its figures and ours in the same columns.
#ifndef oversketch_testing_tables_augment_table_h
#define oversketch_testing_tables_augment_table_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <utility>
#include <vector>

// Prints the table as Markdown, with a row for each of our models.
void augmentTable(const std::vector<std::pair<const char*, vtkSmartPointer<vtkPolyData>>>& models);

#endif
