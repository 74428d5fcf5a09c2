from decomplex_bt.understanding.attributes import KnownMatches
from decomplex_bt.understanding.document import _load_pipeline


def test_matches_are_those_of_the_ruler_at_words_seen_before_and_at_new_ones() -> None:
    nlp = _load_pipeline()
    ruler = nlp.get_pipe("attribute_ruler")
    known = ruler.matcher
    assert isinstance(known, KnownMatches)
    texts = [
        "Don't go. Let's see if it's there.",
        "you gotta  go\nif there's tea",
        "Let's see if it's there, don't go.",
    ]
    for text in (*texts, *texts):
        doc = nlp.make_doc(text)
        for name, component in nlp.pipeline:
            if name == "attribute_ruler":
                options = {"allow_missing": True, "as_spans": False}
                assert sorted(known(doc, **options)) == sorted(known._matcher(doc, **options)), text
            doc = component(doc)
