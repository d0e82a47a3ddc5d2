"""Files as other programs write them, each with what is to be read of it.

    pip install numpy scipy openpyxl pandas odfpy pyarrow h5py pyuff
    python3 make.py

Every file has the same two columns, the decay DECAY or the frequency response RESPONSE, as some program writes them:
those with a Python package by that package, the others by hand from the description of their format. `expected.toml` has
the numbers in SI, and for each file that they are read, or the words of its refusal. `cargo xtask dialects` compares them
with what the program reads.
"""

import datetime
import gzip
import json
import math
import os
import re
import struct
import wave
import zipfile

import h5py
import numpy as np
import openpyxl
import pandas as pd
import pyuff
import scipy.io
import scipy.io.wavfile

HERE = os.path.dirname(os.path.abspath(__file__))
ROWS = 48

# Time in ms and displacement in micrometres, whole numbers: every notation has all their digits.
DECAY = [(2 * n, round(12000 * math.exp(-0.03 * n) * math.cos(0.4 * n))) for n in range(ROWS)]
# Frequency in Hz and receptance in nm/N of 2 kg on 80 kN/m and 40 N s/m.
RESPONSE = [
    (f, round(1e9 / math.hypot(80e3 - 2 * (2 * math.pi * f) ** 2, 40 * 2 * math.pi * f)))
    for f in [20, 22, 24, 26, 28, 30, 31, 32, 33, 34, 36, 38, 40, 44]
]
TRUTH = {
    "decay": {
        "analysis": "vibration/decay-identification",
        "table": "record.samples.samples",
        "rows": [[t / 1e3, x / 1e6] for t, x in DECAY],
    },
    "response": {
        "analysis": "vibration/frequency-response-identification",
        "table": "measurement.table.points",
        "rows": [[2 * math.pi * f, a / 1e9] for f, a in RESPONSE],
    },
}

# Every entry of expected.toml, in the order it is made.
ENTRIES = []


def path(name):
    return os.path.join(HERE, name)


def entry(name, program, part=None, truth="decay", refused=None, within=None, assumed=None, needs=None):
    """What is to be read of a part of a file: the numbers of `truth`, or a refusal with these words."""
    ENTRIES.append(dict(name=name, program=program, part=part, truth=truth, refused=refused, within=within,
                        assumed=assumed, needs=needs))


def write(name, text, encoding="utf-8", newline="\n"):
    data = text.replace("\n", newline).encode(encoding)
    with open(path(name), "wb") as file:
        file.write(data)


def raw(name, data):
    with open(path(name), "wb") as file:
        file.write(data)


def settle(name):
    """Takes the time at which it was made out of a workbook, so that its bytes are the same each time."""
    with zipfile.ZipFile(path(name)) as book:
        parts = [(part.filename, book.read(part)) for part in book.infolist()]
    with zipfile.ZipFile(path(name), "w", zipfile.ZIP_DEFLATED) as book:
        for part, data in parts:
            data = re.sub(rb"20\d\d-\d\d-\d\dT\d\d:\d\d:\d\d(\.\d+)?", b"2024-05-12T00:00:00", data) if "docProps" in part or part == "meta.xml" else data
            book.writestr(zipfile.ZipInfo(part, (2024, 5, 12, 0, 0, 0)), data, zipfile.ZIP_DEFLATED)


def number(x, digits=3, comma=False):
    text = f"{x:.{digits}f}"
    return text.replace(".", ",") if comma else text


def rows(separator, time=lambda t: number(t, 0), value=lambda x: number(x, 0), end=""):
    return "".join(f"{time(t)}{separator}{value(x)}{end}\n" for t, x in DECAY)


def in_seconds(comma=False, digits=3):
    return lambda t: number(t / 1e3, digits, comma)


def in_millimetres(comma=False, digits=3):
    return lambda x: number(x / 1e3, digits, comma)


COMMA = dict(time=in_seconds(True), value=in_millimetres(True))
POINT = dict(time=in_seconds(), value=in_millimetres())


def excel():
    write("excel-en.csv", "t [ms],x [um]\n" + rows(","), newline="\r\n")
    entry("excel-en.csv", "Excel, English, CSV")
    write("excel-de.csv", "Zeit [s];Weg [mm]\n" + rows(";", **COMMA), "cp1252", "\r\n")
    entry("excel-de.csv", "Excel, German, CSV")
    write("excel-pt.csv", "Tempo [s];Deslocamento [µm]\n" + rows(";", time=in_seconds(True)), "cp1252", "\r\n")
    entry("excel-pt.csv", "Excel, Portuguese, CSV in Windows-1252 with a micro sign")
    write("excel-de-utf8.csv", "Zeit [s];Weg [µm]\n" + rows(";", time=in_seconds(True)), "utf-8-sig", "\r\n")
    entry("excel-de-utf8.csv", "Excel, German, CSV UTF-8")
    write("excel-en-unicode.txt", "\ufefft [ms]\tx [µm]\n" + rows("\t"), "utf-16-le", "\r\n")
    entry("excel-en-unicode.txt", "Excel, English, Unicode text")
    write("excel-pt-unicode.txt", "\ufeffTempo [s]\tDeslocação [mm]\n" + rows("\t", **COMMA), "utf-16-le", "\r\n")
    entry("excel-pt-unicode.txt", "Excel, Portuguese, Unicode text")
    write("excel-de-unicode-be.txt", "\ufeffZeit [s]\tWeg [mm]\n" + rows("\t", **COMMA), "utf-16-be", "\r\n")
    entry("excel-de-unicode-be.txt", "Unicode text with big ends first")
    write("excel-de-tab.txt", "Zeit (s)\tWeg (mm)\n" + rows("\t", **COMMA), "cp1252", "\r\n")
    entry("excel-de-tab.txt", "Excel, German, text by tabs")
    write("excel-fr-sep.csv", "sep=;\nTemps (s);Déplacement (mm)\n" + rows(";", **COMMA), "cp1252", "\r\n")
    entry("excel-fr-sep.csv", "Excel, French, with a line that names the separator")
    write("excel-mac.csv", "t [ms],x [um]\n" + rows(","), "mac_roman", "\r")
    entry("excel-mac.csv", "Excel, CSV of the Macintosh, lines end in CR")
    quoted = dict(time=lambda t: '"' + number(t / 1e3, 3, True) + '"', value=lambda x: '"' + number(x / 1e3, 3, True) + '"')
    write("excel-quoted.csv", '"Tempo [s]","Deslocamento [mm]"\n' + rows(",", **quoted), newline="\r\n")
    entry("excel-quoted.csv", "decimal commas in quotation marks between commas")
    write("excel-trailing.csv", "t [s];x [mm];;\n" + rows(";", **COMMA, end=";;") + ";;;\n;;;\n", "cp1252", "\r\n")
    entry("excel-trailing.csv", "Excel, German, with empty cells to the right and below")
    tenth = lambda x: number(x / 1e3, 3, True)
    write("excel-three.csv", "t [s];a [g];x [mm]\n" + "".join(
        f"{number(t / 1e3, 3, True)};{number(n / 10, 1, True)};{tenth(x)}\n" for n, (t, x) in enumerate(DECAY)),
        "cp1252", "\r\n")
    entry("excel-three.csv", "Excel, three columns", refused=["3 columns", "`#1,2`"])
    entry("excel-three.csv", "Excel, columns 1 and 3 of three", part="1,3")
    entry("excel-three.csv", "Excel, the wrong columns of three", part="1,2", refused=["gives g for", "mm"])
    thousands = lambda x: f"{x:,}".replace(",", ".")
    write("excel-de-thousands.csv", "Zeit [s];Weg [µm]\n" + rows(";", time=in_seconds(True), value=thousands), "cp1252")
    entry("excel-de-thousands.csv", "Excel, German, thousands set apart by points", refused=["decimal comma", "thousands"])
    write("excel-en-thousands.csv", "t [ms],x [um]\n" + rows(",", value=lambda x: f'"{x:,}"'))
    entry("excel-en-thousands.csv", "Excel, English, thousands set apart by commas", refused=["line 2"])
    exponent = lambda scale: lambda x: f"{x / scale:.5E}".replace(".", ",")
    write("excel-de-exponent.csv", "t [s];x [mm]\n" + rows(";", time=exponent(1e3), value=exponent(1e3)), "cp1252", "\r\n")
    entry("excel-de-exponent.csv", "Excel, German, scientific notation")
    write("excel-units-in-cells.csv", "t;x\n" + rows(";", time=lambda t: f"{t} ms", value=lambda x: f"{x} µm"), "cp1252")
    entry("excel-units-in-cells.csv", "a unit in each cell")
    write("excel-comma-comma.csv", "t [s],x [mm]\n" + rows(",", **COMMA), newline="\r\n")
    entry("excel-comma-comma.csv", "decimal commas between commas", refused=["twice as many commas", "semicolons"])
    entry("excel-comma-comma.csv", "decimal commas between commas, columns chosen", part="1,3", refused=["twice as many commas"])
    write("excel-title.csv", "Versuch 7;\nDatum;12.05.2024\nPrüfer;Müller\n;\nZeit [s];Weg [mm]\n" + rows(";", **COMMA), "cp1252", "\r\n")
    entry("excel-title.csv", "Excel, German, with a title block")
    write("excel-no-heading.csv", rows(";", **COMMA), "cp1252", "\r\n")
    entry("excel-no-heading.csv", "Excel, German, without a heading", assumed=["s", "mm"])
    write("google-sheets.csv", "time (ms),displacement (µm)\n" + rows(",").rstrip("\n"))
    entry("google-sheets.csv", "Google Sheets, no line feed at the end")
    write("libreoffice.csv", '"t / ms","x / µm"\n' + rows(","))
    entry("libreoffice.csv", "LibreOffice Calc, headings in the style of ISO 80000")


def workbooks():
    def book(name, title, lines, more=()):
        made = openpyxl.Workbook()
        sheet = made.active
        sheet.title = title
        for line in lines:
            sheet.append(line)
        for other, cells in more:
            page = made.create_sheet(other)
            for line in cells:
                page.append(line)
        made.save(path(name))
        settle(name)

    plain = [["t [ms]", "x [µm]"]] + [list(row) for row in DECAY]
    book("excel.xlsx", "Sheet1", plain)
    entry("excel.xlsx", "Excel, workbook")
    titled = [["Decay of the arm"], ["Operator", "Ana", None], [], ["t", None, "x"], ["ms", None, "µm"]]
    titled += [[t, "note", x] for t, x in DECAY]
    book("excel-title.xlsx", "Run 1", [["Nothing here"]], [("Run 2", titled)])
    entry("excel-title.xlsx", "Excel, workbook, two of three columns below a title", part="Run 2!A,C")
    entry("excel-title.xlsx", "Excel, workbook, a range of cells", part=f"Run 2!A4:A{5 + ROWS},C4:C{5 + ROWS}")
    entry("excel-title.xlsx", "Excel, workbook, an unknown sheet", part="Run 9", refused=["`Run 9`", "`Run 2`"])
    block = [["Model", "QX840"], ["Rate in Hz", 500], ["Time", "Way"], ["ms", "µm"]] + [list(row) for row in DECAY]
    book("excel-preamble.xlsx", "Data", block)
    entry("excel-preamble.xlsx", "Excel, workbook, a preamble with numbers above the heading")
    entry("excel-preamble.xlsx", "Excel, workbook, rows skipped", part="skip=2")
    dates = [["t", "x [mm]"]]
    dates += [[datetime.datetime(2024, 5, 12, 10, 0, 0, 1000 * t), x / 1e3] for t, x in DECAY]
    book("excel-dates.xlsx", "Data", dates)
    entry("excel-dates.xlsx", "Excel, workbook, dates in place of times", refused=["A2", "date"])
    book("excel-formulas.xlsx", "Data", [["t [ms]", "x [µm]"]] + [[t, f"={x}*1"] for t, x in DECAY])
    entry("excel-formulas.xlsx", "a workbook whose formulas were never computed", refused=["line 2"])
    book("excel-text.xlsx", "Data", [["t [s]", "x [mm]"]] + [
        [number(t / 1e3, 3, True), number(x / 1e3, 3, True)] for t, x in DECAY])
    entry("excel-text.xlsx", "Excel, workbook, numbers kept as text with a decimal comma")
    frame = pd.DataFrame({"t_ms": [t for t, _ in DECAY], "x_um": [x for _, x in DECAY]})
    frame.to_excel(path("pandas-index.xlsx"))
    settle("pandas-index.xlsx")
    entry("pandas-index.xlsx", "pandas, to_excel with its index", refused=["3 columns"])
    entry("pandas-index.xlsx", "pandas, to_excel, columns B and C", part="Sheet1!B:C")
    frame.to_excel(path("pandas.ods"), engine="odf", index=False)
    settle("pandas.ods")
    entry("pandas.ods", "pandas, to_excel in OpenDocument")
    response = pd.DataFrame({"f [Hz]": [f for f, _ in RESPONSE], "H [nm/N]": [a for _, a in RESPONSE]})
    with pd.ExcelWriter(path("two-sheets.ods"), engine="odf") as writer:
        frame.to_excel(writer, sheet_name="Decay", index=False)
        response.to_excel(writer, sheet_name="Response", index=False)
    settle("two-sheets.ods")
    entry("two-sheets.ods", "OpenDocument, the second sheet", part="Response", truth="response")
    raw("archive.csv", open(path("excel.xlsx"), "rb").read())
    entry("archive.csv", "a workbook renamed to .csv", refused=["archive", ".xlsx"])
    raw("old.xls", b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1" + bytes(504))
    entry("old.xls", "Excel, workbook of the old format", refused=[".xlsx"])


def languages():
    frame = pd.DataFrame({"t_ms": [t for t, _ in DECAY], "x_um": [x for _, x in DECAY]})
    frame.to_csv(path("pandas-index.csv"))
    entry("pandas-index.csv", "pandas, to_csv with its index", refused=["3 columns"])
    entry("pandas-index.csv", "pandas, to_csv, columns 2 and 3", part="2,3")
    frame.to_csv(path("pandas-tab.csv"), sep="\t", index=False)
    entry("pandas-tab.csv", "pandas, to_csv by tabs")
    scaled = pd.DataFrame({"t [s]": frame["t_ms"] / 1e3, "x [mm]": frame["x_um"] / 1e3})
    scaled.to_csv(path("pandas-comma.csv"), sep=";", decimal=",", index=False)
    entry("pandas-comma.csv", "pandas, to_csv with decimal commas")
    array = scaled.to_numpy()
    np.savetxt(path("numpy.txt"), array)
    entry("numpy.txt", "NumPy, savetxt", assumed=["s", "mm"])
    np.savetxt(path("numpy-header.txt"), np.array(DECAY), header="t [ms], x [um]", delimiter=", ")
    entry("numpy-header.txt", "NumPy, savetxt with a header")
    np.savetxt(path("numpy-comments.txt"), array, header="Duration [ms], 46\nlevel [um], 3", fmt="%.6e")
    entry("numpy-comments.txt", "NumPy, savetxt with remarks that are no heading", assumed=["s", "mm"])
    lines = "".join(f'"{n + 1}",{t},{x}\n' for n, (t, x) in enumerate(DECAY))
    write("r.csv", '"","t_ms","x_um"\n' + lines)
    entry("r.csv", "R, write.csv with row names", refused=["3 columns"])
    entry("r.csv", "R, write.csv, columns 2 and 3", part="2,3")
    write("r2.csv", '"t_s";"x_mm"\n' + rows(";", **COMMA))
    entry("r2.csv", "R, write.csv2")
    ascii_row = lambda scale: lambda x: f"  {x / scale:.8e}"
    write("octave-ascii.txt", rows("", time=ascii_row(1e3), value=ascii_row(1e3)))
    entry("octave-ascii.txt", "Octave, save -ascii", assumed=["s", "mm"])
    write("octave-text.txt", f"# Created by Octave 8.4.0\n# name: signal\n# type: matrix\n# rows: {ROWS}\n# columns: 2\n"
          + rows(" ", **POINT, end="") + "\n\n")
    entry("octave-text.txt", "Octave, save -text", assumed=["s", "mm"])
    write("matlab-writetable.csv", "Time_ms,Displacement_um\n" + rows(","), newline="\r\n")
    entry("matlab-writetable.csv", "MATLAB, writetable")
    write("gnuplot.dat", "# t/ms x/um\n" + rows(" "))
    entry("gnuplot.dat", "gnuplot, units in a remark")
    fortran = lambda scale: lambda x: f" {x / scale:.8E}".replace("E", "D")
    write("fortran.dat", rows("", time=fortran(1e3), value=fortran(1e3)))
    entry("fortran.dat", "Fortran, exponents with D", assumed=["s", "mm"])
    write("nan.csv", "t [ms],x [um]\n" + rows(",").replace(f"\n6,{DECAY[3][1]}\n", "\n6,NaN\n"))
    entry("nan.csv", "a missing number as NaN", refused=["line 5", "NaN"])
    write("dashes.csv", "t [ms];x [um]\n" + rows(";").replace(f"\n6;{DECAY[3][1]}\n", "\n6;--\n"))
    entry("dashes.csv", "a missing number as dashes", refused=["line 5"])
    write("footer.csv", "t [ms];x [um]\n" + rows(";") + "Mean;12\n")
    entry("footer.csv", "a line of words below the rows", refused=[f"line {ROWS + 2}"])
    write("stamps.csv", "Timestamp,x [mm]\n" + "".join(
        f"2024-05-12 10:00:00.{t:03},{number(x / 1e3)}\n" for t, x in DECAY))
    entry("stamps.csv", "a date and time of day in each row", refused=["line 2", "write the time in seconds"])
    write("clock.csv", "Time;x [mm]\n" + "".join(f"00:00:00.{t:03};{number(x / 1e3)}\n" for t, x in DECAY))
    entry("clock.csv", "a time of day in each row", refused=["line 2", "write the time in seconds"])
    write("wrong-unit.csv", "t [ms],F [N]\n" + rows(","))
    entry("wrong-unit.csv", "forces in place of displacements", refused=["gives N for", "mm"])
    write("unknown-unit.csv", "t [ms],x [px]\n" + rows(","))
    entry("unknown-unit.csv", "a unit that there is not", refused=["px"])


def oscilloscopes():
    preamble = ("Model,MSO46\nFirmware Version,1.28.7\nWaveform Type,ANALOG\nPoint Format,Y\nHorizontal Units,s\n"
                "Horizontal Scale,0.004\nHorizontal Delay,0.0\nSample Interval,0.002\nRecord Length,48\n"
                "Gating,0.0% to 100.0%\nProbe Attenuation,1\nVertical Units,{}\nVertical Offset,0\nVertical Scale,2\n"
                "Vertical Position,0\n,\n,\nLabel,\nTIME,CH1\n")
    write("tektronix.csv", preamble.format("mm") + rows(",", **POINT), newline="\r\n")
    entry("tektronix.csv", "Tektronix MSO, a channel scaled to mm")
    entry("tektronix.csv", "Tektronix MSO, its preamble skipped", part="skip=18", assumed=["s", "mm"])
    write("tektronix-volts.csv", preamble.format("V") + rows(",", **POINT), newline="\r\n")
    entry("tektronix-volts.csv", "Tektronix MSO, volts", refused=["unknown unit `V`"])
    keys = ["Record Length,4.8e+01,", "Sample Interval,2.0e-03,", "Trigger Point,0.0e+00,", ",,", ",,", "Source,CH1,",
            "Vertical Units,mm,", "Vertical Scale,2.0e+00,", "Vertical Offset,0.0e+00,", "Horizontal Units,s,"]
    beside = [f"{keys[n] if n < len(keys) else ',,'},{t / 1e3:.6f},{x / 1e3:.5f},\n" for n, (t, x) in enumerate(DECAY)]
    write("tektronix-tds.csv", "".join(beside), newline="\r\n")
    entry("tektronix-tds.csv", "Tektronix TDS, keys beside the rows", refused=["5 columns", "`#1,2`"])
    entry("tektronix-tds.csv", "Tektronix TDS, columns 4 and 5", part="4,5")
    samples = "".join(f"{n},{number(x / 1e3, 4)},\n" for n, (_, x) in enumerate(DECAY))
    write("rigol-volts.csv", "X,CH1,Start,Increment,\nSequence,Volt,0.000000e+00,2.000000e-03\n" + samples)
    entry("rigol-volts.csv", "Rigol DS1000Z, volts against the number of a sample", refused=["unknown unit `V`"])
    write("rigol.csv", "X,CH1,Start,Increment,\nSequence,mm,0.000000e+00,2.000000e-03\n" + samples)
    entry("rigol.csv", "Rigol DS1000Z, a channel in mm against the number of a sample")
    write("rigol-mso.csv", "Time(s),CH1(mm),t0 =0.000000e+00, tInc = 2.000000e-03,\n" + rows(",", **POINT, end=",,"))
    entry("rigol-mso.csv", "Rigol MSO5000")
    entry("rigol-mso.csv", "Rigol MSO5000, its first line skipped", part="skip=1", assumed=["s", "mm"])
    write("siglent.csv", "Record Length,Analog:48\nSample Interval,Analog:2.0e-03\nVertical Units,CH1:mm\n"
          "Vertical Scale,CH1:2.00\nModel Number,SDS1104X-E\nSerial Number,none\nSource,CH1\nSecond,mm\n" + rows(",", **POINT))
    entry("siglent.csv", "Siglent SDS, units with the name of the channel")
    entry("siglent.csv", "Siglent SDS, the lines above the heading skipped", part="skip=7")
    write("keysight.csv", "x-axis,1\nsecond,Volt\n" + rows(",", **POINT))
    entry("keysight.csv", "Keysight InfiniiVision, volts", refused=["unknown unit `V`"])
    write("picoscope.csv", "Time,Channel A\n(ms),(µm)\n\n" + rows(","), "utf-8", "\r\n")
    entry("picoscope.csv", "PicoScope, a line of units in brackets and a blank line")
    write("picoscope-volts.csv", "Time,Channel A\n(ms),(mV)\n\n" + rows(","), "utf-8", "\r\n")
    entry("picoscope-volts.csv", "PicoScope, millivolts", refused=["unknown unit `mV`"])
    write("lecroy.csv", "LECROYWS4104,61234,Waveform\nSegments,1,SegmentSize,48\nSegment,TrigTime,TimeSinceSegment1\n"
          "#1,12-May-2024 10:11:12,0\nTime,Ampl\n" + rows(",", **POINT), newline="\r\n")
    entry("lecroy.csv", "LeCroy, trace as text", assumed=["s", "mm"])


def loggers():
    header = ("LabVIEW Measurement\t\nWriter_Version\t2\nReader_Version\t2\nSeparator\tTab\nDecimal_Separator\t{mark}\n"
              "Multi_Headings\tNo\nX_Columns\t{x}\nTime_Pref\tRelative\nOperator\tana\nDate\t2024/05/12\n"
              "Time\t10:11:12.123456\n***End_of_Header***\t\n\t\n")
    segment = ("Channels\t{n}\t\nSamples\t48\t\nDate\t2024/05/12\t\nTime\t10:11:12.123456\t\nY_Unit_Label\t{units}\t\n"
               "X_Dimension\tTime\t\nX0\t0.0000000000000000E+0\t\nDelta_X\t{step}\t\n***End_of_Header***\t\t\n")
    one = header.format(mark=".", x="One") + segment.format(n=1, units="mm", step="0.002000")
    write("labview.lvm", one + "X_Value\tDisplacement\tComment\n" + rows("\t", **POINT), newline="\r\n")
    entry("labview.lvm", "LabVIEW, one column of times")
    none = header.format(mark=".", x="No") + segment.format(n=1, units="um", step="0.002000")
    write("labview-no-times.lvm", none + "X_Value\tDisplacement\tComment\n" + rows("", time=lambda t: "\t"), newline="\r\n")
    entry("labview-no-times.lvm", "LabVIEW, times by the step alone")
    comma = header.format(mark=",", x="One") + segment.format(n=1, units="mm", step="0,002000")
    write("labview-comma.lvm", comma + "X_Value\tWeg\tComment\n" + rows("\t", **COMMA), newline="\r\n")
    entry("labview-comma.lvm", "LabVIEW, decimal commas")
    two = header.format(mark=".", x="One") + segment.format(n=2, units="g\tmm", step="0.002000\t0.002000")
    write("labview-two.lvm", two + "X_Value\tAcceleration\tDisplacement\tComment\n" + "".join(
        f"{number(t / 1e3)}\t{n / 10:.1f}\t{number(x / 1e3)}\n" for n, (t, x) in enumerate(DECAY)))
    entry("labview-two.lvm", "LabVIEW, two channels", refused=["3 columns"])
    entry("labview-two.lvm", "LabVIEW, the second channel", part="1,3")
    entry("labview-two.lvm", "LabVIEW, accelerations in place of displacements", part="1,2", refused=["gives g for"])
    write("labview-segments.lvm", one + "X_Value\tDisplacement\tComment\n" + rows("\t", **POINT)
          + segment.format(n=1, units="mm", step="0.002") + "X_Value\tDisplacement\tComment\n" + rows("\t", **POINT))
    entry("labview-segments.lvm", "LabVIEW, two sets of rows", refused=["one set of measurements", "skip="])
    catman = ("Datei:\tversuch7.tst\nDatum:\t12.05.2024 10:11:12\nAnzahl der Kanäle:\t2\nLänge:\t48\n"
              "Abtastrate [Hz]:\t500\n\nZeit  1 - Standardmessrate [s]\tWeg [mm]\n")
    write("catman.asc", catman + rows("\t", **COMMA), "cp1252", "\r\n")
    entry("catman.asc", "catman, ASCII with a header of channels")
    write("catman-units.asc", "Zeit\tWeg\ns\tmm\n500 Hz\t500 Hz\n" + rows("\t", **COMMA), "cp1252", "\r\n")
    entry("catman-units.asc", "catman, units and rates below the names", refused=["line 3"])
    entry("catman-units.asc", "catman, the lines above the rows skipped", part="skip=3", assumed=["s", "mm"])
    write("origin.dat", "Time\tDisplacement\nms\tµm\nRun 1\tsensor A\n" + rows("\t"), "cp1252", "\r\n")
    entry("origin.dat", "Origin, long names, units and comments")
    write("origin-short.dat", "A\tB\nTime\tDisplacement\nms\tum\n\t\n" + rows("\t"), newline="\r\n")
    entry("origin-short.dat", "Origin, short names, long names and units, an empty line")
    write("testlab-frf.txt", "Frequency\tPoint arm:1:+Z/arm:1:+Z\nHz\tnm/N\n" + "".join(
        f"{f}\t{a}\n" for f, a in RESPONSE), newline="\r\n")
    entry("testlab-frf.txt", "Testlab, copied function with a line of units", truth="response")
    write("testlab.txt", "Title1:\tFRF arm:1:+Z\nProject:\tarm\nX axis unit:\tHz\nY axis unit:\tnm/N\nNumber of lines:\t14\n"
          "Linear\tAmplitude\n" + "".join(f"{f:.6E}\t{a:.6E}\n" for f, a in RESPONSE), newline="\r\n")
    entry("testlab.txt", "Testlab, ASCII with the units of its axes above", truth="response")
    write("testlab-phase.txt", "Frequency\tAmplitude\tPhase\nHz\tnm/N\t°\n" + "".join(
        f"{f}\t{a}\t{-n}\n" for n, (f, a) in enumerate(RESPONSE)), "cp1252", "\r\n")
    entry("testlab-phase.txt", "Testlab, amplitude and phase", truth="response", refused=["3 columns"])
    entry("testlab-phase.txt", "Testlab, the amplitude alone", truth="response", part="1,2")
    write("dewesoft.txt", "Data file name:\tarm.dxd\nStart time:\t12.05.2024 10:11:12\nSample rate:\t500 Hz\nNo. channels:\t1\n"
          "\nTime (s)\tAI 1 (mm)\n" + rows("\t", **COMMA), newline="\r\n")
    entry("dewesoft.txt", "DEWESoft, text export")
    write("polytec.txt", "Source File Name: \tarm.pvd\nPoint Index: \t1\nComponent: \tRoot Point\nSignal: \tFRF\n\n"
          "Frequency\tMagnitude\n[ Hz ]\t[ nm/N ]\n" + "".join(f"{f}\t{a}\n" for f, a in RESPONSE), newline="\r\n")
    entry("polytec.txt", "Polytec, ASCII of a point", truth="response")
    write("diadem.csv", "Kanalname;Zeit;Weg\nEinheit;s;mm\nAnzahl;48;48\n;Zeit;Weg\n" + "".join(
        f"{n};{number(t / 1e3, 3, True)};{number(x / 1e3, 3, True)}\n" for n, (t, x) in enumerate(DECAY)), "cp1252")
    entry("diadem.csv", "DIAdem, keys in the first column", part="2,3")
    write("arduino.csv", "ms,um\n" + rows(","), newline="\r\n")
    entry("arduino.csv", "a microcontroller, a line of units alone")
    write("phyphox.csv", '"Time (s)","Position (mm)"\n' + rows(",", time=lambda t: f"{t / 1e3:.9E}", value=lambda x: f"{x / 1e3:.9E}"))
    entry("phyphox.csv", "phyphox, CSV with a decimal point")
    write("phyphox-acceleration.csv", '"Time (s)","Linear Acceleration x (m/s^2)"\n' + rows(",", **POINT))
    entry("phyphox-acceleration.csv", "phyphox, accelerations", refused=["m/s^2", "mm"])
    write("logger-pro.txt", "Latest: Time (s)\tLatest: Position (mm)\n" + rows("\t", **POINT))
    entry("logger-pro.txt", "Logger Pro, text")
    write("capstone.csv", "Time (s) Run #1,Position (mm) Run #1\n" + rows(",", **POINT))
    entry("capstone.csv", "PASCO Capstone, CSV")
    write("tracker.txt", "#multi:\nmass_A\nt\tx\n" + rows("\t", **POINT))
    entry("tracker.txt", "Tracker, a track as text", assumed=["s", "mm"])
    write("abaqus.rpt", "\n             X        U:U2 N: 7\n\n" + rows("", time=lambda t: f"{t / 1e3:14.6E}", value=lambda x: f"{x / 1e3:17.6E}") + "\n\n")
    entry("abaqus.rpt", "Abaqus, XY report", assumed=["s", "mm"])
    write("adams.tab", "Time\tMARKER_2.X\nsec\tmm\n" + rows("\t", **POINT))
    entry("adams.tab", "Adams, a result set by tabs")
    write("unit-in-preamble.csv", "Operator,Ana\nUnit,um\nRate,500\ntime,way\n" + rows(","))
    entry("unit-in-preamble.csv", "a preamble whose units are not those of the columns", refused=["line 2", "skip=2"])


def recordings():
    shares = np.array([x / 12000 * 0.9 for _, x in DECAY])
    # The full scale is 1, in the unit that is assumed: 1 mm.
    TRUTH["recording"] = dict(TRUTH["decay"], rows=[[t / 1e3, x / 12000 * 0.9 / 1e3] for t, x in DECAY])
    rate = 500
    scipy.io.wavfile.write(path("float32.wav"), rate, shares.astype(np.float32))
    entry("float32.wav", "WAV of 32-bit floating-point numbers", truth="recording", within=1e-6, assumed=["mm"])
    scipy.io.wavfile.write(path("pcm16.wav"), rate, np.round(shares * 32768).astype(np.int16))
    entry("pcm16.wav", "WAV of 16-bit whole numbers", truth="recording", within=3e-5, assumed=["mm"])
    scipy.io.wavfile.write(path("pcm32.wav"), rate, np.round(shares * 2**31).astype(np.int32))
    entry("pcm32.wav", "WAV of 32-bit whole numbers", truth="recording", within=1e-8, assumed=["mm"])
    scipy.io.wavfile.write(path("pcm8.wav"), rate, (np.round(shares * 128) + 128).astype(np.uint8))
    entry("pcm8.wav", "WAV of 8-bit whole numbers", truth="recording", within=6e-3, assumed=["mm"])
    with wave.open(path("pcm24.wav"), "wb") as file:
        file.setparams((1, 3, rate, 0, "NONE", ""))
        file.writeframes(b"".join(struct.pack("<i", round(x * 2**23))[:3] for x in shares))
    entry("pcm24.wav", "WAV of 24-bit whole numbers", truth="recording", within=2e-7, assumed=["mm"])
    two = np.stack([np.linspace(0, 0.5, ROWS), shares], axis=1).astype(np.float32)
    scipy.io.wavfile.write(path("stereo.wav"), rate, two)
    entry("stereo.wav", "WAV of two channels", truth="recording", refused=["2 channels", "`#1`"])
    entry("stereo.wav", "WAV, its second channel", truth="recording", part="2", within=1e-6, assumed=["mm"])
    entry("stereo.wav", "WAV, a third of two channels", truth="recording", part="3", refused=["channel 3"])
    scipy.io.wavfile.write(path("float64.wav"), rate, shares)
    entry("float64.wav", "WAV of 64-bit floating-point numbers", truth="recording", refused=["32-bit"])
    raw("compressed.wav", b"ID3\x04" + bytes(60))
    entry("compressed.wav", "a compressed recording renamed to .wav", truth="recording", refused=["PCM"])


def matlab():
    signal = np.array([[t / 1e3, x / 1e3] for t, x in DECAY])
    t, x = signal[:, :1], signal[:, 1:]

    def save(name, variables, **options):
        scipy.io.savemat(path(name), variables, **options)
        # The header has the time of day in it.
        data = bytearray(open(path(name), "rb").read())
        if options.get("format") != "4":
            data[:116] = b"MATLAB 5.0 MAT-file, written by SciPy".ljust(116)
        raw(name, bytes(data))

    save("matrix.mat", {"signal": signal}, do_compression=True)
    entry("matrix.mat", "MATLAB 7, one matrix", assumed=["s", "mm"])
    entry("matrix.mat", "MATLAB 7, the matrix by its name", part="signal", assumed=["s", "mm"])
    save("plain.mat", {"signal": signal})
    entry("plain.mat", "MATLAB 6, not compressed", assumed=["s", "mm"])
    save("vectors.mat", {"t": t, "x": x, "fs": 500.0, "title": "arm"})
    entry("vectors.mat", "MATLAB, several vectors", refused=["`t` 48×1", "`x` 48×1", "#t,x"])
    entry("vectors.mat", "MATLAB, two vectors by their names", part="t,x", assumed=["s", "mm"])
    entry("vectors.mat", "MATLAB, a vector that there is not", part="t,y", refused=["`y`", "`x` 48×1"])
    entry("vectors.mat", "MATLAB, a text in place of numbers", part="t,title", refused=["`title` is a text"])
    save("rows.mat", {"t_ms": (t.T * 1e3).round().astype(np.int16), "x_um": (x.T * 1e3).round().astype(np.int16)},
         do_compression=True)
    entry("rows.mat", "MATLAB, rows of 16-bit numbers whose names have units", part="t_ms,x_um")
    save("struct.mat", {"run": {"t": t, "x": x, "sensor": "A"}}, do_compression=True)
    entry("struct.mat", "MATLAB, a structure", refused=["`run.t` 48×1", "`run.x` 48×1"])
    entry("struct.mat", "MATLAB, fields of a structure", part="run.t,run.x", assumed=["s", "mm"])
    wide = np.hstack([t, x * 0 + 1, x])
    save("wide.mat", {"data": wide, "other": wide}, do_compression=True)
    entry("wide.mat", "MATLAB, matrices of three columns", refused=["`data` 48×3"])
    entry("wide.mat", "MATLAB, two columns of a matrix", part="data!1,3", assumed=["s", "mm"])
    save("complex.mat", {"t": t, "z": x * 1j}, do_compression=True)
    entry("complex.mat", "MATLAB, complex numbers", part="t,z", refused=["`z` is complex"])
    save("version4.mat", {"signal": signal}, format="4")
    entry("version4.mat", "MATLAB 4", refused=["-v7"])
    with h5py.File(path("version73.mat"), "w", track_order=False) as file:
        file.create_dataset("signal", data=signal.T, track_times=False)
    data = open(path("version73.mat"), "rb").read()
    raw("version73.mat", b"MATLAB 7.3 MAT-file, written by h5py".ljust(124) + b"\x00\x02IM" + bytes(384) + data)
    entry("version73.mat", "MATLAB 7.3", refused=["7.3", "-v7"])
    raw("measurement.h5", data)
    entry("measurement.h5", "HDF5", refused=["HDF5", "CSV"])


def universal():
    def function(name, node):
        data = np.array([a / 1e9 for _, a in RESPONSE], dtype=float)
        return dict(type=58, binary=0, func_type=4, ver_num=0, load_case_id=0, rsp_ent_name="NONE", rsp_node=node,
                    rsp_dir=3, ref_ent_name="NONE", ref_node=1, ref_dir=3, id1=name, id2="NONE", id3="NONE", id4="NONE",
                    id5="NONE", x=np.array([f for f, _ in RESPONSE], dtype=float), data=data + 0j, data_type=2,
                    num_pts=len(data), abscissa_spacing=0, abscissa_min=20.0, abscissa_inc=0, z_axis_value=0,
                    abscissa_spec_data_type=18, abscissa_len_unit_exp=0, abscissa_force_unit_exp=0,
                    abscissa_temp_unit_exp=0, abscissa_axis_lab="Frequency", abscissa_axis_units_lab="Hz",
                    ordinate_spec_data_type=8, ordinate_len_unit_exp=0, ordinate_force_unit_exp=0,
                    ordinate_temp_unit_exp=0, ordinate_axis_lab="Displacement", ordinate_axis_units_lab="m",
                    orddenom_spec_data_type=13, orddenom_len_unit_exp=0, orddenom_force_unit_exp=0,
                    orddenom_temp_unit_exp=0, orddenom_axis_lab="Force", orddenom_axis_units_lab="N",
                    z_axis_axis_lab="", z_axis_axis_units_lab="", z_axis_spec_data_type=0, z_axis_len_unit_exp=0,
                    z_axis_force_unit_exp=0, z_axis_temp_unit_exp=0)

    made = pyuff.UFF(path("function.uff"))
    made.write_sets(function("FRF arm", 1), "overwrite", force_double=True)
    entry("function.uff", "pyuff, dataset 58", truth="response", within=1e-5)
    # The same records with the values as bytes.
    records = open(path("function.uff"), "rb").read().split(b"\n")[2:13]
    values = b"".join(struct.pack("<3d", f, a / 1e9, 0.0) for f, a in RESPONSE)
    head = f"    -1\n    58b{1:6}{2:6}{11:12}{len(values):12}{0:6}{0:6}{0:12}{0:12}\n".encode()
    raw("function-binary.uff", head + b"\n".join(records) + b"\n" + values + b"\n    -1\n")
    entry("function-binary.uff", "universal file, dataset 58 in binary", truth="response", within=1e-5)
    made = pyuff.UFF(path("functions.uff"))
    other = function("FRF tip", 2)
    other["data"] = other["data"] * 3
    made.write_sets(other, "overwrite", force_double=True)
    made.write_sets(function("FRF arm", 1), "add", force_double=True)
    entry("functions.uff", "universal file with two functions", truth="response", refused=["2 functions", "FRF tip", "FRF arm"])
    entry("functions.uff", "universal file, function 2", truth="response", part="2", within=1e-5)
    entry("functions.uff", "universal file, a function by its name", truth="response", part="FRF arm", within=1e-5)
    entry("functions.uff", "universal file, a function that there is not", truth="response", part="9", refused=["no function 9", "FRF arm"])
    entry("function.uff", "frequency response in place of a decay", refused=["Hz"])
    made = pyuff.UFF(path("nodes.uff"))
    made.write_sets(dict(type=15, node_nums=[1, 2], def_cs=[0, 0], disp_cs=[0, 0], color=[1, 1], x=[0.0, 1.0], y=[0.0, 0.0],
                        z=[0.0, 0.0]), "overwrite")
    entry("nodes.uff", "universal file without functions", refused=["no function"])


def parquet():
    frame = pd.DataFrame({"t [ms]": [float(t) for t, _ in DECAY], "x [um]": [float(x) for _, x in DECAY]})
    frame.to_parquet(path("pandas.parquet"))
    entry("pandas.parquet", "pandas, to_parquet", needs="parquet")
    frame["note"] = "a"
    frame["run"] = 3
    frame.to_parquet(path("wide.parquet"))
    entry("wide.parquet", "Parquet with a third column of numbers", refused=["3 columns of numbers", "`run`"], needs="parquet")
    entry("wide.parquet", "Parquet, columns by their names", part="t,x", needs="parquet")


def others():
    raw("empty.csv", b"")
    entry("empty.csv", "an empty file", refused=["empty"])
    raw("picture.csv", b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR" + bytes(20))
    entry("picture.csv", "a picture", refused=["not a text file"])
    raw("packed.csv.gz", gzip.compress(("t,x\n" + rows(",")).encode(), mtime=0))
    entry("packed.csv.gz", "a compressed text", refused=["gzip"])
    write("page.xls", "<html><body><table>\n<tr><td>t [s]</td><td>x [mm]</td></tr>\n<tr><td>0</td><td>12</td></tr>\n</table></body></html>\n")
    entry("page.xls", "a page of a web interface, named .xls", refused=["no row of numbers"])
    write("record.json", json.dumps({"t": [0, 0.002], "x": [12, 9]}, indent=1) + "\n")
    entry("record.json", "JSON", refused=["line"])
    write("users.txt", "root:x:0:0:root:/root:/bin/bash\nana:x:1000:1000:Ana Example,,,:/home/ana:/bin/sh\n")
    entry("users.txt", "a list of users", refused=["no row of numbers"])


def toml_text(value):
    return json.dumps(value, ensure_ascii=False)


def expected():
    out = ["# What is to be read of the files of this folder; written by make.py.\n\n"]
    for name, truth in TRUTH.items():
        out.append(f"[truth.{name}]\nanalysis = {toml_text(truth['analysis'])}\ntable = {toml_text(truth['table'])}\n")
        out.append("# In SI.\nrows = [\n" + "".join(f"    [{a!r}, {b!r}],\n" for a, b in truth["rows"]) + "]\n\n")
    for one in ENTRIES:
        out.append("[[file]]\n")
        for key in ["name", "program", "part", "truth", "within", "assumed", "refused", "needs"]:
            value = one[key]
            if value is None or key == "truth" and one["refused"] and value == "decay":
                continue
            out.append(f"{key} = {toml_text(value) if not isinstance(value, float) else repr(value)}\n")
        out.append("\n")
    with open(path("expected.toml"), "w", encoding="utf-8") as file:
        file.write("".join(out).rstrip("\n") + "\n")


if __name__ == "__main__":
    for make in [excel, workbooks, languages, oscilloscopes, loggers, recordings, matlab, universal, parquet, others]:
        make()
    expected()
    print(f"{len({one['name'] for one in ENTRIES})} files, {len(ENTRIES)} readings")
