# What other programs see in a picture that the command has drawn, as lines for viewers_test.cpp:
#   paths FILE.svg     how many paths vpype finds, which is what it would send to a plotter
#   dots FILE.pdf      of the one dot that pdfium draws: width, height and dark pixels
import sys


def paths(name):
    import vpype

    document = vpype.read_multilayer_svg(name, quantization=0.1)
    print(sum(len(layer) for layer in document.layers.values()))


def dots(name):
    import pypdfium2

    image = pypdfium2.PdfDocument(name)[0].render(scale=8).to_numpy()[:, :, 0]
    rows, columns = (image < 128).nonzero()
    print(columns.max() - columns.min() + 1, rows.max() - rows.min() + 1, len(rows))


{"paths": paths, "dots": dots}[sys.argv[1]](sys.argv[2])
