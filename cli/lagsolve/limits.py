"""Sizes and times that the command keeps to. Those of progress on a terminal are in `progress_line`."""

# -- output ------------------------------------------------------------------------------------------------------------

NARROWEST = 20
"""Columns of a terminal that formulas are still broken for."""

WIDEST = 1_000
"""Columns that are believed: no terminal has more, and lines are filled up to the width that COLUMNS says."""

PIPED_WIDTH = 80
"""Columns where there is no terminal and COLUMNS says nothing: what terminals and mail have by convention."""

LONGEST_INTERNAL_ERROR = 300
"""Characters of an exception that is a mistake of this program: SymPy may put a whole equation into one."""

WATCH_SECONDS = 0.25
"""Between two looks at the files of --watch: an answer within half a second of a save, for four `stat` a second."""

# -- bounds of a command -----------------------------------------------------------------------------------------------

SHARE_FOR_EXPLAINING = 0.25
"""The share of --timeout that is added for explaining and printing what is known when it is over."""

LARGEST_CALL = 4
"""Stack of a call by way of C, in those of `min` with a key, 200 bytes: taken before --memory, as deep as calls go."""

SPARE_MEMORY = 4 << 20
"""Bytes beyond --memory, for what has to be done when nothing is left of it."""

CHECK_SECONDS, CHECK_MEGABYTES = 60.0, 1024
"""For `check`, as for one submission of `grade`."""

# -- grading: submissions and pages ------------------------------------------------------------------------------------

MOST_FILES = 50
"""In the folder of one submission; more than that means that the wrong folder was named."""

MOST_PROBLEMS = 16
"""In one assignment: each is solved in every process, and kept there."""

MOST_ROSTER_ROWS = 20_000
"""Rows of a table of students: a large university has as many in a year."""

FEWEST_NAMED = 2
"""Who must have made a mistake for it to be on the page about the class: of one person it would tell who."""

MOST_MISTAKES_LISTED = 40
"""On the page about the class: more would not be read."""

LONGEST_REMARK = 300
"""Characters of a remark in the table: four lines of a terminal."""

LONGEST_PAGE_NAME = 80
"""Bytes of the name of a page without its extension; with a hash and `.md` that is less than half of the 255 that file
systems allow.
"""

MAX_JOURNAL_LINE = 1 << 16
"""Bytes of a line of the journal; a row with a name of 255 bytes and the longest remark has 4,000, escaped."""

MOST_COUNTED = 10_000
"""Equations that a row of the journal may count; problems ask for a dozen."""

# -- grading: processes ------------------------------------------------------------------------------------------------

AHEAD = 4
"""Submissions handed over for each process, so that none waits for the next; a thousand are not held in memory."""

TRIES = 2
"""Tries of a submission whose process is lost: once may have another cause (the system was short of memory)."""

STARTS = 3
"""Starts of a process that is lost before it is ready, after which the batch gives up."""

MOST_KEPT_OUTCOMES = 5_000
"""Outcomes that are kept for equal submissions, some 2 kB each: a course has fewer different ones."""

SETUP_SECONDS = 600.0
"""In which a process has to solve the problems of a batch; the heaviest shipped one takes 3 s on an idle machine."""

POLL_SECONDS = 0.5
"""Between two looks at the clock while no submission is ready, for the line of progress and for Ctrl-C."""

PROGRESS_ON_TERMINAL, PROGRESS_ELSEWHERE = 0.2, 15.0
"""Seconds between two lines of progress: one that is replaced, and one that stays in a log."""

PARENT_SECONDS = 1.0
"""Between two looks of a worker process at whether its parent is there."""

SPARE_SECONDS = 5
"""By which processor time may exceed the limit before the system stops a process, should its parent not have."""

MAX_FRAME = 1 << 26
"""Bytes sent between processes at once; a submission has 1 MiB at most, a verdict on it less."""

# -- grading: a cluster ------------------------------------------------------------------------------------------------

CLUSTER_SECONDS = 20
"""Within which the scheduler and a first worker must answer, so that a wrong address is soon reported."""

IDLE_SECONDS = 60.0
"""After which a process without work ends on a cluster, where nothing tells it that the batch is over."""

MOST_CLUSTERS = 8
"""Mistakes of several submissions that are listed below the table of a batch, the most frequent ones."""

LONGEST_HEADING = 120
"""Characters of a line that may be the heading of a part of a submission."""

BINS = 10
"""Columns of the distribution of points, each of 10 %."""

ROUNDED_COMPONENT = 1e-14
"""A component of the state that is so much smaller than the others, and than 1, is a rounding error of 0."""
