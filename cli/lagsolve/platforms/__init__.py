"""What teaching platforms read and write: results, tables of marks, questions, files to begin with."""
