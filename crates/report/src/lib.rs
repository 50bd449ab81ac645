//! Error metrics, tables and the report.
